package org.u2sa.flightgear.link;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.time.Clock;

/**
 * Restores FlightGear's channels through its property server: removes the dead channel and adds an
 * identical one. FlightGear runs such commands only while its lines are read, so a separate thread
 * sends them. Confined to the link's thread.
 */
final class Repair {
  private static final long SHORTEST_PAUSE_MICROS = Clock.MICROS_PER_SECOND;
  private static final long LONGEST_PAUSE_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final String NOT_NEEDED = "no longer needed";

  private final FlightGearAddress address;
  private final Troubles troubles;
  private final Channel out = new Channel("out", "generic-1", ProtocolFiles.OUT);
  private final Channel in = new Channel("in", "generic-2", ProtocolFiles.IN);
  private CompletableFuture<String>
      work; // its result: the error, or empty; null if no repair is running
  private long nextMicros;
  private long pauseMicros = SHORTEST_PAUSE_MICROS;
  private boolean failing;
  private int attempts;

  Repair(FlightGearAddress address, Troubles troubles) {
    this.address = address;
    this.troubles = troubles;
  }

  /**
   * Asks FlightGear to connect to this program. Before the first connection no channel is removed,
   * because it may belong to another program.
   *
   * @param needed evaluated on another thread when FlightGear answers, because FlightGear may have
   *     connected in the meantime
   */
  void out(int port, boolean hadOne, long nowMicros, BooleanSupplier needed) {
    if (isDue(nowMicros)) {
      start(out, port, hadOne, nowMicros, needed);
    }
  }

  /** Asks FlightGear to listen again. */
  void in(long nowMicros) {
    if (isDue(nowMicros)) {
      start(in, address.inPort(), true, nowMicros, () -> true);
    }
  }

  private boolean isDue(long nowMicros) {
    return address.propertyPort().isPresent() && work == null && nowMicros >= nextMicros;
  }

  private void start(
      Channel channel, int port, boolean remove, long nowMicros, BooleanSupplier needed) {
    boolean oursFirst = !remove || attempts % 2 == 1;
    CompletableFuture<String> begun = new CompletableFuture<>();
    work = begun;
    attempts++;
    Runnable repair =
        () -> {
          try (PropertyServer server =
              new PropertyServer(address.host(), address.propertyPort().getAsInt())) {
            String known = channel.askConfig(server);
            if (!needed.getAsBoolean()) {
              begun.complete(NOT_NEEDED);
              return;
            }
            channel.remove(server, remove);
            String ours = channel.config(address.rateHz(), peerOf(channel, server), port, known);
            channel.add(server, nowMicros, oursFirst ? List.of(ours, known) : List.of(known, ours));
            begun.complete("");
          } catch (IOException e) {
            begun.complete(e.getMessage());
          } finally {
            begun.complete("an error in this program"); // no effect if already complete
          }
        };
    Thread thread = new Thread(repair, "flightgear-repair");
    thread.setDaemon(true);
    thread.start();
  }

  private String peerOf(Channel channel, PropertyServer server) {
    if (channel == in) {
      return address.host();
    }
    boolean everywhere = address.bindHost().equals("0.0.0.0") || address.bindHost().equals("::");
    return everywhere ? server.ownAddress() : address.bindHost();
  }

  /** Whether a repair is running. */
  boolean isBusy() {
    return work != null;
  }

  /** Reports the result of the last attempt; repeated failures are reported once. */
  void tick(long nowMicros) {
    if (work == null || !work.isDone()) {
      return;
    }
    String problem = work.join();
    work = null;
    if (problem.equals(NOT_NEEDED)) {
      return;
    }
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
    nextMicros = nowMicros + pauseMicros;
  }

  /**
   * One of FlightGear's channels. Used by one repair at a time. The name of an added channel is
   * fixed, so that another process can remove it: a channel whose name is unknown holds its port
   * for the life of FlightGear.
   */
  private static final class Channel {
    private static final int RATE = 3; // index in a configuration

    private final String direction;
    private final String protocol;
    private final String ours;
    private String name;
    private String knownConfig = "";

    private Channel(String direction, String name, String protocol) {
      this.direction = direction;
      this.name = name;
      this.protocol = protocol;
      ours = "u2sa-" + direction;
    }

    /** Configuration of this channel: as FlightGear was started, or as added last. */
    private String askConfig(PropertyServer server) throws IOException {
      for (String each : List.of(ours, name)) {
        String config = server.get("/io/channels/" + each + "/config");
        if (config.startsWith("generic,socket," + direction + ",")) {
          knownConfig = config;
        }
      }
      return knownConfig;
    }

    /**
     * Removes a channel added by an earlier process and, if requested, the present one. FlightGear
     * refuses to remove a channel that does not exist.
     */
    private void remove(PropertyServer server, boolean present) throws IOException {
      server.run("remove-io-channel name=" + ours);
      if (present && !name.equals(ours)) {
        server.run("remove-io-channel name=" + name);
      }
    }

    private String config(int usualRateHz, String host, int port, String known) {
      String rate = known.isEmpty() ? String.valueOf(usualRateHz) : known.split(",")[RATE];
      return String.join(
          ",", "generic", "socket", direction, rate, host, String.valueOf(port), "tcp", protocol);
    }

    private void add(PropertyServer server, long nowMicros, List<String> configs)
        throws IOException {
      for (String config : configs) {
        for (String each : List.of(ours, ours + "-" + nowMicros)) {
          if (!config.isEmpty()
              && server.run("add-io-channel name=" + each + " config=" + config)) {
            name = each;
            return;
          }
        }
      }
      throw new IOException("FlightGear refused to add " + String.join(" and ", configs));
    }
  }
}
