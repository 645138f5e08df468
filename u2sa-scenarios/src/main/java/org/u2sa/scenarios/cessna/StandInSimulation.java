package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.link.StandInFlightGear;
import org.u2sa.flightgear.link.StandInSetup;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.mission.Mission;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.trials.run.Simulation;

/**
 * Embedded aircraft in real time that speaks FlightGear's protocol, on free ports of this machine.
 */
final class StandInSimulation implements Simulation {
  private static final String HOST = "127.0.0.1";

  private final StandInFlightGear standIn;
  private final int outPort;

  private StandInSimulation(Mission mission, Wind wind) {
    Cessna172 aircraft = Cessna172.onRunway(EmbeddedStart.of(mission), wind, true);
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      standIn =
          new StandInFlightGear(
              aircraft, StandInSetup.likeFlightGear(), HOST, 0, 0, new SystemClock());
      outPort = free.getLocalPort();
    } catch (IOException e) {
      throw new UncheckedIOException("no free TCP port for the FlightGear stand-in", e);
    }
  }

  /** Creates a simulation, and points the Simulator service at it. */
  static StandInSimulation of(Mission mission, Wind wind, LaunchOptions options) {
    StandInSimulation made = new StandInSimulation(mission, wind);
    FlightGearPorts.configure(
        options, HOST, made.outPort, made.standIn.inPort(), made.standIn.propertyPort());
    return made;
  }

  @Override
  public void start() {
    standIn.start(HOST, outPort);
  }

  @Override
  public String name() {
    return "embedded Cessna 172 behind FlightGear's protocol";
  }

  @Override
  public String vehicle() {
    return "aircraft";
  }

  @Override
  public void close() {
    standIn.close();
  }
}
