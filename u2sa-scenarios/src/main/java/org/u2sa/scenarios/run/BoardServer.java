package org.u2sa.scenarios.run;

import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioTcpServer;

/** A simulated board in real time, listening on an ephemeral TCP port of this machine. */
public final class BoardServer implements Simulation {
  private final IoioTcpServer server;
  private final String name;

  /**
   * @param name the simulation's name in reports
   */
  public BoardServer(IoioFirmware board, String name) {
    this.name = name;
    server = new IoioTcpServer(board, new SystemClock(), 0);
  }

  /** Value of the variable CONNECTION to reach the board. */
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
