package org.u2sa.scenarios.run;

import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioTcpServer;

/** A simulated board in real time, on a free TCP port of this machine: it listens at once. */
public final class BoardServer implements Simulation {
  private final IoioTcpServer server;
  private final String name;

  /**
   * @param name of the simulation in reports
   */
  public BoardServer(IoioFirmware board, String name) {
    this.name = name;
    server = new IoioTcpServer(board, new SystemClock(), 0);
  }

  /** What the variable CONNECTION must be. */
  public String address() {
    return "tcp:127.0.0.1:" + server.port();
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public void close() {
    server.close();
  }
}
