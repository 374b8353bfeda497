/// Sandbox: the command line of bubblewrap, by which a program sees only the system's files, its scene and a folder in
/// memory.
///
/// Inside, the program is the user `nobody` of a user namespace of its own. Outside it is the grader's user or, if root
/// grades, a user that owns nothing. Root's numbers are never in the namespace, so neither are root's rights.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grade/keeper.h"

namespace vidno {

constexpr const char* folder_inside = "/work";
constexpr const char* program_inside = "/program";

/// A command and the descriptors that it is to inherit.
struct SandboxCommand {
    std::vector<std::string> words;
    std::vector<Descriptor> inherited;
};

/// A file that the program may read: its name inside, and its text.
using FileInside = std::pair<std::string, std::string>;

/// The command that prepares the sandbox, writes a line to the descriptor `handshake`, and becomes the program when it
/// can read a line from there. `handshake` has one digit, since shells take no more. Throws Refused if the program
/// cannot be read.
SandboxCommand sandbox_command(const std::string& bubblewrap, const std::string& program,
                               const std::vector<std::pair<std::string, std::string>>& variables,
                               const std::vector<FileInside>& files, std::uint64_t folder_size, int handshake);

/// Makes root another user, for good; does nothing for others. Only calls async-signal-safe functions.
bool leave_root();
/// Makes root this user, for good.
bool leave_root_for(unsigned user);

/// Whether the calls by which a program takes memory of the system, or reaches beyond its files, can be refused here.
bool can_refuse_calls();

}  // namespace vidno
