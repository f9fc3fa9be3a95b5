// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fuzzer's bytes choose the files in a TRX archive: as bytes of an archive, nearly all of them
// would end at its checksums. make_seeds.py knows the order of the choices.

#include "FuzzReader.h"

#include "vtkNew.h"
#include "vtkTRXReader.h"

#include <archive.h>
#include <archive_entry.h>
#include <fuzzer/FuzzedDataProvider.h>

#include <vector>

namespace
{
constexpr const char* Names[] = { "positions.3.", "offsets.", "dpv/a.", "dpv/b.2.", "dps/a.",
  "dps/b.3.", "groups/a.", "groups/b.", "dpg/a/b.", "dpg/a/b.2.", "header.", "c." };

constexpr const char* Types[] = { "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32",
  "uint64", "float16", "float32", "float64", "bit", "json" };

//------------------------------------------------------------------------------
std::string MakeHeader(FuzzedDataProvider& choices)
{
  const std::string lines = std::to_string(choices.ConsumeIntegralInRange(-1, 20));
  const std::string points = std::to_string(choices.ConsumeIntegralInRange(-1, 20));
  return "{\"NB_STREAMLINES\": " + lines + ", \"NB_VERTICES\": " + points +
    ", \"DIMENSIONS\": [1, 2, 3]}";
}

//------------------------------------------------------------------------------
void Write(archive* zip, const std::string& name, const std::string& content)
{
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, name.c_str());
  archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_entry_set_perm(entry, 0644);
  archive_write_header(zip, entry);
  archive_write_data(zip, content.data(), content.size());
  archive_entry_free(entry);
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> MakeArchive(FuzzedDataProvider& choices)
{
  std::vector<std::uint8_t> bytes(1 << 17);
  std::size_t used = 0;
  archive* zip = archive_write_new();
  archive_write_set_format_zip(zip);
  choices.ConsumeBool() ? archive_write_zip_set_compression_deflate(zip)
                        : archive_write_zip_set_compression_store(zip);
  Require(archive_write_open_memory(zip, bytes.data(), bytes.size(), &used) == ARCHIVE_OK,
    "an archive can be written");
  Write(zip, "header.json",
    choices.ConsumeIntegralInRange(0, 7) > 0 ? MakeHeader(choices)
                                             : choices.ConsumeRandomLengthString());
  for (int count = choices.ConsumeIntegralInRange(0, 12); count > 0; --count)
  {
    const std::string name = choices.PickValueInArray(Names);
    const std::string type = choices.PickValueInArray(Types);
    const auto size = choices.ConsumeIntegralInRange<std::size_t>(0, 255);
    Write(zip, name + type, choices.ConsumeBytesAsString(size));
  }
  archive_write_close(zip);
  archive_write_free(zip);
  bytes.resize(used);
  return bytes;
}
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider choices(data, size);
  const std::vector<std::uint8_t> file = MakeArchive(choices);
  vtkNew<vtkTRXReader> reader;
  FuzzReader(reader, file.data(), file.size());
  return 0;
}
