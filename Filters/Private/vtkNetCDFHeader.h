// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNetCDFHeader
 * @brief   Whether a file is NetCDF, and holds all bytes that its header claims.
 *
 * Private to the module. The NetCDF library reads zeros where a file in a classic format (CDF-1,
 * CDF-2, CDF-5) has been cut off, and allocates what its header claims; here the header is walked
 * first. Files of NetCDF-4 are left to the HDF5 library, which knows their length.
 *
 * Source: NetCDF Classic Format Specification (Unidata, NetCDF User's Guide, appendix).
 *
 * @sa vtkNetCDFFile
 */

#ifndef vtkNetCDFHeader_h
#define vtkNetCDFHeader_h

#include "vtkABINamespace.h"

#include <cstdint> // for sizes
#include <string>  // for the file's name

VTK_ABI_NAMESPACE_BEGIN

struct vtkNetCDFHeader
{
  /** The file's length in bytes; throws vtkTrajectoryFileError. */
  static std::uint64_t Check(const std::string& fileName);

  /** A claimed number of bytes, for messages. */
  static std::string FormatSize(double size);
};

VTK_ABI_NAMESPACE_END
#endif
