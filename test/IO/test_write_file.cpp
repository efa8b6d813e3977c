// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of files that appear complete or not at all.

#include "support/Temporary_folder.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/exceptions.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace {

using namespace test_support;

TEST(Write_file, creates_and_replaces)
{
  const Temporary_folder folder;
  const std::string filename = folder.file("a.txt");
  CSCD::write_file(filename, [](std::ostream& out) { out << "a longer first content"; });
  EXPECT_EQ("a longer first content", read_file(filename));
  CSCD::write_file(filename, [](std::ostream& out) { out << "second"; });
  EXPECT_EQ("second", read_file(filename));
  EXPECT_EQ(1, folder.number_of_files());
}

TEST(Write_file, failure_leaves_no_new_file)
{
  const Temporary_folder folder;
  const auto fail = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(CSCD::write_file(folder.file("a.txt"), fail), std::runtime_error);
  EXPECT_EQ(0, folder.number_of_files());
}

TEST(Write_file, failure_keeps_the_old_file)
{
  const Temporary_folder folder;
  const std::string filename = folder.write("a.txt", "old");
  const auto fail = [](std::ostream& out) { out.setstate(std::ios::badbit); };
  EXPECT_THROW(CSCD::write_file(filename, fail), CSCD::File_error);
  EXPECT_EQ("old", read_file(filename));
  EXPECT_EQ(1, folder.number_of_files());
}

TEST(Write_file, missing_folder_and_folder_are_refused_by_name)
{
  const Temporary_folder folder;
  for (const std::string& filename : {folder.file("missing/a.txt"), folder.path().string()}) {
    try {
      CSCD::write_file(filename, [](std::ostream& out) { out << "content"; });
      ADD_FAILURE() << filename;
    } catch (const CSCD::File_error& error) {
      EXPECT_EQ(0u, std::string(error.what()).rfind(filename + ": cannot be written", 0)) << error.what();
    }
  }
}

TEST(Write_file, folder_without_permission_is_refused)
{
  if (geteuid() == 0) {
    GTEST_SKIP() << "the superuser may write everywhere";
  }
  const Temporary_folder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(CSCD::write_file(folder.file("a.txt"), [](std::ostream&) {}), CSCD::File_error);
}

TEST(Write_file, full_disk_is_noticed)
{
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no /dev/full";
  }
  EXPECT_THROW(CSCD::write_file("/dev/full", [](std::ostream& out) { out << std::string(100000, 'x'); }),
               CSCD::File_error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")); // not replaced by a file
}

TEST(Write_file, link_stays_a_link)
{
  const Temporary_folder folder;
  const std::string target = folder.write("target.txt", "old");
  const std::string link = folder.file("link.txt");
  std::filesystem::create_symlink(target, link);
  CSCD::write_file(link, [](std::ostream& out) { out << "new"; });
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ("new", read_file(target));
}

TEST(Write_file, permissions_are_kept)
{
  const Temporary_folder folder;
  const std::string filename = folder.write("a.txt", "old");
  constexpr auto own = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(filename, own);
  CSCD::write_file(filename, [](std::ostream& out) { out << "new"; });
  EXPECT_EQ("new", read_file(filename));
  EXPECT_EQ(own, std::filesystem::status(filename).permissions());
}

TEST(File_group, appears_when_it_is_published)
{
  const Temporary_folder folder;
  const std::string old = folder.write("old.txt", "old");
  CSCD::File_group files;
  files.write(old, [](std::ostream& out) { out << "first"; });
  files.write(folder.file("new.txt"), [](std::ostream& out) { out << "second"; });
  EXPECT_EQ("old", read_file(old));
  EXPECT_FALSE(std::filesystem::exists(folder.file("new.txt")));
  files.publish();
  EXPECT_EQ("first", read_file(old));
  EXPECT_EQ("second", read_file(folder.file("new.txt")));
  EXPECT_EQ(2, folder.number_of_files());
}

TEST(File_group, does_not_appear_when_a_file_fails)
{
  const Temporary_folder folder;
  const std::string old = folder.write("old.txt", "old");
  const auto write_two = [&] {
    CSCD::File_group files;
    files.write(old, [](std::ostream& out) { out << "first"; });
    files.write(folder.file("missing/new.txt"), [](std::ostream& out) { out << "second"; });
    files.publish();
  };
  EXPECT_THROW(write_two(), CSCD::File_error);
  EXPECT_EQ("old", read_file(old));
  EXPECT_EQ(1, folder.number_of_files());
}

} // namespace
