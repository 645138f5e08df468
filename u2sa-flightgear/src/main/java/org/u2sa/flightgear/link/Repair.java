package org.u2sa.flightgear.link;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.time.Clock;

/**
 * Brings FlightGear's channels back over its property server: takes the dead one away and adds one
 * like it. FlightGear runs such commands only while its lines are read, so they are sent from a
 * thread of their own. Belongs to the link's thread.
 */
final class Repair {
  private static final long SHORTEST_PAUSE_MICROS = Clock.MICROS_PER_SECOND;
  private static final long LONGEST_PAUSE_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final String NOT_NEEDED = "not needed any more";

  private final FlightGearAddress address;
  private final Troubles troubles;
  private final Channel out = new Channel("out", "generic-1", ProtocolFiles.OUT);
  private final Channel in = new Channel("in", "generic-2", ProtocolFiles.IN);
  private CompletableFuture<String>
      work; // its result: what went wrong, or empty; null if none is under way
  private long nextMicros;
  private long pauseMicros = SHORTEST_PAUSE_MICROS;
  private boolean failing;
  private int attempts;

  Repair(FlightGearAddress address, Troubles troubles) {
    this.address = address;
    this.troubles = troubles;
  }

  /**
   * Asks FlightGear to connect to us. Before the first connection no channel is taken away, since
   * it may be another program's.
   *
   * @param needed asked, by another thread, when FlightGear answers: it may have connected
   *     meanwhile
   */
  void out(int port, boolean hadOne, long nowMicros, BooleanSupplier needed) {
    if (isDue(nowMicros)) {
      start(out, port, hadOne, nowMicros, needed);
    }
  }

  /** Asks FlightGear to listen to us again. */
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
            begun.complete("an error in this program"); // without effect if it is complete
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
   * One of FlightGear's channels; touched by one repair at a time, and repairs happen one after the
   * other. The name of what we add is always the same, so that another process finds it again: a
   * channel that nobody can name keeps its port for ever.
   */
  private static final class Channel {
    private static final int RATE = 3; // place in a configuration

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

    /** What FlightGear has this channel for: as it was started, or as we added it last. */
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
     * Takes away what a process before us added, and, if wanted, what is there now. FlightGear
     * refuses what is gone already.
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
