package org.u2sa.scenarios.ugv;

import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.scenarios.run.Simulation;
import org.u2sa.sim.ioio.IoioTcpServer;

/** The simulated board in real time, on a free TCP port of this machine. */
final class BoardServer implements Simulation {
  private final IoioTcpServer server;
  private final String name;

  BoardServer(UgvWorld world, String name) {
    this.name = name;
    server = new IoioTcpServer(world.board(), new SystemClock(), 0);
  }

  /** What the variable CONNECTION must be. */
  String address() {
    return "tcp:127.0.0.1:" + server.port();
  }

  @Override
  public void start() {
    // it has listened since it was made: the services may connect before
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String vehicle() {
    return "vehicle";
  }

  @Override
  public void close() {
    server.close();
  }
}
