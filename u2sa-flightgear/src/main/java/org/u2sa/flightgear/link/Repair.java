package org.u2sa.flightgear.link;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.Clock;

/**
 * Brings FlightGear's channels back over its property server: takes the dead one away and adds one
 * like it. FlightGear runs such commands only while its lines are read, so they are sent from a
 * thread of their own. Belongs to the link's thread.
 */
final class Repair {
  private static final long SHORTEST_PAUSE_MICROS = Clock.MICROS_PER_SECOND;
  private static final long LONGEST_PAUSE_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final FlightGearAddress address;
  private final Troubles troubles;
  private final Channel out = new Channel("out", "generic-1", ProtocolFiles.OUT);
  private final Channel in = new Channel("in", "generic-2", ProtocolFiles.IN);
  private CompletableFuture<String>
      work; // its result: what went wrong, or empty; null if none is under way
  private long nextMicros;
  private long pauseMicros = SHORTEST_PAUSE_MICROS;
  private boolean failing;

  Repair(FlightGearAddress address, Troubles troubles) {
    this.address = address;
    this.troubles = troubles;
  }

  /**
   * Asks FlightGear to connect to us; before the first connection no channel is taken away, since
   * it may be another program's.
   */
  void out(int port, boolean hadOne, long nowMicros) {
    start(out, hadOne, port, nowMicros);
  }

  /** Asks FlightGear to listen to us again. @return whether that was begun */
  boolean in(long nowMicros) {
    return start(in, true, address.inPort(), nowMicros);
  }

  private boolean start(Channel channel, boolean remove, int port, long nowMicros) {
    if (address.propertyPort().isEmpty() || work != null || nowMicros < nextMicros) {
      return false;
    }
    String newName =
        "u2sa-" + channel.direction + "-" + nowMicros; // a name that no run before has left behind
    CompletableFuture<String> begun = new CompletableFuture<>();
    work = begun;
    Thread thread =
        new Thread(() -> run(channel, remove, port, newName, begun), "flightgear-repair");
    thread.setDaemon(true);
    thread.start();
    return true;
  }

  private void run(
      Channel channel, boolean remove, int port, String newName, CompletableFuture<String> done) {
    int propertyPort = address.propertyPort().getAsInt();
    try (PropertyServer server = new PropertyServer(address.host(), propertyPort)) {
      if (remove) {
        server.run(
            "remove-io-channel name="
                + channel.name); // refused if FlightGear has dropped it already: as good
      }
      String host = channel == in ? address.host() : reachable(server);
      String config =
          String.join(
              ",",
              "generic",
              "socket",
              channel.direction,
              String.valueOf(address.rateHz()),
              host,
              String.valueOf(port),
              "tcp",
              channel.protocol);
      if (!server.run("add-io-channel name=" + newName + " config=" + config)) {
        throw new IOException("FlightGear refused to add the channel " + config);
      }
      channel.name = newName;
      done.complete("");
    } catch (IOException e) {
      done.complete(e.getMessage());
    } finally {
      done.complete("interrupted by an error"); // without effect if it is complete
    }
  }

  private String reachable(PropertyServer server) {
    boolean everywhere = address.bindHost().equals("0.0.0.0") || address.bindHost().equals("::");
    return everywhere ? server.ownAddress() : address.bindHost();
  }

  /** Whether FlightGear is being asked just now. */
  boolean isBusy() {
    return work != null;
  }

  /** Says how the last attempt went; failures once only. */
  void tick(long nowMicros) {
    if (work == null || !work.isDone()) {
      return;
    }
    String problem = work.join();
    work = null;
    nextMicros = nowMicros + pauseMicros;
    if (problem.isEmpty()) {
      troubles.event("asked FlightGear to restore the link");
      pauseMicros = SHORTEST_PAUSE_MICROS;
    } else {
      if (!failing) {
        troubles.event(
            "FlightGear cannot be asked to restore the link: " + problem + "; trying again");
      }
      pauseMicros = Math.min(LONGEST_PAUSE_MICROS, 2 * pauseMicros);
    }
    failing = !problem.isEmpty();
  }

  /** One of FlightGear's channels. */
  private static final class Channel {
    private final String direction;
    private final String protocol;
    private volatile String name;

    private Channel(String direction, String name, String protocol) {
      this.direction = direction;
      this.name = name;
      this.protocol = protocol;
    }
  }
}
