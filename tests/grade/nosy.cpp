// A program that looks for files and a network outside its sandbox and prints whether it found them.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "course.h"

/// Whether there is a route for a datagram; without a network interface there is none.
bool has_network() {
    const int socket_number = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(9);
    address.sin_addr.s_addr = htonl(0xc0000201);  // 192.0.2.1, reserved for documentation
    const bool reached = connect(socket_number, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(socket_number);
    return reached;
}

int main() {
    const Scene scene = scene_to_draw(example_scene());
    WarnockTrace trace("nosy.jsonl", scene);
    const bool has_secret = std::ifstream("/etc/passwd").good();
    const bool has_home = std::ifstream("/root/.bashrc").good() || access("/home", F_OK) == 0;
    const bool can_write = access("/usr", W_OK) == 0;
    std::cout << (has_secret || has_home || can_write ? "a secret" : "no secret")
              << (has_network() ? ", a network" : ", no network") << std::endl;
}
