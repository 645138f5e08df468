package org.u2sa.scenarios.cessna;

import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.scenarios.run.Simulation;

/** FlightGear that somebody else starts and stops: says what it must be told. */
final class AwaitedFlightGear implements Simulation {
  private final Terminal terminal;
  private final FlightGearPorts ports;

  AwaitedFlightGear(Terminal terminal, FlightGearPorts ports) {
    this.terminal = terminal;
    this.ports = ports;
  }

  @Override
  public void start() {
    terminal
        .out()
        .printf(
            "Listening. Start FlightGear now, with%n"
                + "  --data=DIR --generic=socket,out,20,THIS-HOST,%d,tcp,u2sa-out --generic=socket,in,20,,%d,tcp,u2sa-in%s%n",
            ports.out(),
            ports.in(),
            ports.property() == 0 ? "" : " --props=socket,bi,20,," + ports.property() + ",tcp");
    terminal.out().flush();
  }

  @Override
  public String name() {
    return "FlightGear";
  }

  @Override
  public String vehicle() {
    return "aircraft";
  }

  @Override
  public void close() {
    // whoever started it stops it
  }
}
