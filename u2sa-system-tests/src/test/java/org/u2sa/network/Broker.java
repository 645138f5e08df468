package org.u2sa.network;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Which broker a system on several hosts has, and how it is started on one of them. */
enum Broker {
  /** Debian's. */
  MOSQUITTO {
    @Override
    List<String> program(Path folder, String address, List<String> run) throws IOException {
      Path file = folder.resolve("mosquitto.conf");
      Files.writeString(
          file,
          "listener "
              + PORT
              + " "
              + address
              + "\nallow_anonymous true\nmax_queued_messages 100000\n");
      return List.of("mosquitto", "-c", file.toString());
    }
  },

  /** The Communication Manager's own, in a process without services. */
  EMBEDDED {
    @Override
    List<String> program(Path folder, String address, List<String> run) {
      return run;
    }
  };

  static final int PORT = 1883; // nobody else is on these hosts

  /**
   * The command that runs the broker.
   *
   * @param address of the host that carries it
   * @param run the command that runs what the system file gives to that host
   */
  abstract List<String> program(Path folder, String address, List<String> run) throws IOException;
}
