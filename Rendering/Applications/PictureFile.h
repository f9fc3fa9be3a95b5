// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Picture files: which names are understood, and writing them.
 */

#ifndef PictureFile_h
#define PictureFile_h

#include <string> // for names

class vtkImageData;

namespace pellucid
{
/** Whether the name ends in one of the suffixes that can be written. */
bool IsPictureFileName(const std::string& fileName);

/** ".png, .jpg, ..." */
std::string ListPictureSuffixes();

/** Throw RenderError unless a file of that name can be written; leaves no file behind. */
void CheckWritable(const std::string& fileName);

/** Write 3 or 4 components of unsigned char; throw RenderError when that fails. */
void WritePicture(vtkImageData* picture, const std::string& fileName);
}

#endif
