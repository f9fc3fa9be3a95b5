// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What the buffer objects of OpenGL take.
 */

#ifndef BufferMemory_h
#define BufferMemory_h

#include "vtkType.h"

namespace pellucid
{
namespace benchmark
{
/** Bytes of all buffer objects of the current context, whoever made them. Textures do not count. */
vtkIdType FindBufferBytes();
}
}

#endif
