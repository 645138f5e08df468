package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Stands in for FlightGear: the same protocol, start-up and connection failures, with the Cessna of
 * u2sa-sim. Like FlightGear it runs everything in the frames of one thread, so it freezes while its
 * lines are not read.
 */
public final class StandInFlightGear implements AutoCloseable {
  private static final long END_MS = 2_000;
  private static final double BEFORE_FLIGHT_ALTITUDE_M = -9_999.0 * 0.3048;

  private final Cessna172 aircraft;
  private final StandInSetup setup;
  private final Clock clock;
  private final String host;
  private final StandInInput input;
  private final StandInProperties properties;
  private final Map<String, StandInChannel> channels =
      new LinkedHashMap<>(); // by FlightGear's names; confined to its thread
  private volatile InLine told = InLine.nothing();
  private volatile OutLine said = OutLine.of(Map.of(OutField.ALTITUDE, BEFORE_FLIGHT_ALTITUDE_M));
  private volatile String trouble = "";
  private volatile boolean ending;
  private volatile double speedUp;
  private boolean engineKilled;
  private Thread thread;

  /**
   * Listens for controls and property commands.
   *
   * @param aircraft at its initial state; no other object may advance it
   * @param host local address
   * @param inPort 0 for a free port
   * @param propertyPort 0 for a free port
   * @throws IOException if a port is taken
   */
  public StandInFlightGear(
      Cessna172 aircraft,
      StandInSetup setup,
      String host,
      int inPort,
      int propertyPort,
      Clock clock)
      throws IOException {
    this.aircraft = aircraft;
    this.setup = setup;
    this.speedUp = setup.speedUp();
    this.clock = clock;
    this.host = host;
    this.input = new StandInInput(host, inPort);
    try {
      this.properties = new StandInProperties(this, host, propertyPort);
    } catch (IOException e) {
      input.close();
      throw e;
    }
  }

  /** Port for controls. */
  public int inPort() {
    return input.port();
  }

  /** Port of the property server. */
  public int propertyPort() {
    return properties.port();
  }

  /** Commands received last. */
  public InLine told() {
    return told;
  }

  /** Line sent last. */
  public OutLine said() {
    return said;
  }

  /** Last error; empty if none. */
  public String trouble() {
    return trouble;
  }

  /**
   * Starts the flight and connects once. Without a listener, the flight continues without output,
   * as in FlightGear.
   */
  public void start(String peerHost, int outPort) {
    thread = new Thread(() -> run(peerHost, outPort), "stand-in-flightgear");
    thread.setDaemon(true);
    properties.noteConfig("generic-1", "out", peerHost, outPort, ProtocolFiles.OUT);
    properties.noteConfig("generic-2", "in", host, inPort(), ProtocolFiles.IN);
    thread.start();
  }

  private void run(String peerHost, int outPort) {
    add("generic-1", () -> new StandInOutput(peerHost, outPort));
    channels.put("generic-2", input);
    long periodMicros = Clock.micros(1.0 / setup.rateHz());
    long flightMicros = clock.micros() + Clock.micros(setup.loadingS());
    try (Clock.Waiter waiter = clock.newWaiter("stand-in-flightgear")) {
      long due = clock.micros();
      while (!ending) {
        frame(clock.micros() >= flightMicros);
        due =
            Math.max(
                due + periodMicros,
                clock.micros() - periodMicros); // frames missed while frozen are skipped
        waiter.await(due);
      }
    } catch (IOException e) {
      trouble = e.getMessage();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      channels.values().forEach(this::closed);
      channels.clear();
      closed(properties);
      closed(input);
    }
  }

  private void frame(boolean flightModelRuns) throws IOException {
    if (flightModelRuns) {
      fly();
    }
    for (Map.Entry<String, StandInChannel> each : Map.copyOf(channels).entrySet()) {
      try {
        told = each.getValue().work(told, said);
      } catch (IOException e) {
        trouble = each.getKey() + ": " + e.getMessage();
        closed(channels.remove(each.getKey()));
      }
    }
    properties.work();
  }

  private void fly() {
    boolean first = said.isBeforeFlight();
    boolean primer = aircraft.state().timeS() < setup.primerS();
    if (first && setup.primerS() > 0.0) {
      aircraft.startEngine();
    }
    ControlInputs controls = told.controls();
    engineKilled |= primer && told.count() > 0 && !StartingEngine.survives(controls);
    if (speedUp > 0.0) {
      aircraft.step(engineKilled ? controls.withMixture(0.0) : controls, speedUp / setup.rateHz());
    }
    double elapsedS = aircraft.state().timeS();
    said =
        Readings.line(
            EmbeddedAircraft.reading(aircraft.state(), 1, 0).state(),
            elapsedS,
            elapsedS < setup.primerS(),
            told.count());
  }

  /**
   * Adds a channel; on its own thread only.
   *
   * @return whether it could be opened
   */
  boolean add(String name, Opening opening) {
    try {
      channels.put(name, opening.open());
      return true;
    } catch (IOException e) {
      trouble = name + ": " + e.getMessage();
      return false;
    }
  }

  /**
   * Removes a channel; on its own thread only.
   *
   * @return whether it existed
   */
  boolean remove(String name) {
    StandInChannel channel = channels.remove(name);
    if (channel != null) {
      closed(channel);
    }
    return channel != null;
  }

  String host() {
    return host;
  }

  double speedUp() {
    return speedUp;
  }

  /** Sets the simulated seconds per second of wall time; 0 pauses the flight. */
  void speedUp(double newSpeedUp) {
    speedUp = newSpeedUp;
  }

  /** Ends the flight after this frame. */
  void exit() {
    ending = true;
  }

  private void closed(Closeable thing) {
    try {
      thing.close();
    } catch (IOException e) {
      trouble = e.getMessage();
    }
  }

  /** Ends the flight and all connections, as if FlightGear were killed. */
  @Override
  public void close() {
    ending = true;
    if (thread == null) {
      closed(input);
      closed(properties);
      return;
    }
    thread.interrupt(); // it may be blocked writing to a peer that does not read
    try {
      thread.join(END_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Opens a channel. */
  interface Opening {
    StandInChannel open() throws IOException;
  }
}
