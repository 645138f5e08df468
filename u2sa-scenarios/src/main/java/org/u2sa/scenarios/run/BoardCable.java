package org.u2sa.scenarios.run;

import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.ioio.Pins;

/** A simulated IOIO board between a vehicle's pins and the services. */
public final class BoardCable {
  private final IoioFirmware board;
  private final IoioInProcess cable;

  /** Connects an IOIO-OTG to these pins. */
  public BoardCable(Pins pins) {
    board = new IoioFirmware(IoioBoard.OTG, pins);
    cable = new IoioInProcess(board);
  }

  /** Connection within this process, in lockstep. */
  public BoardConnection connection() {
    return new LockstepConnection(
        cable::connect, cable::disconnect, cable::input, cable::output, cable::exchange);
  }

  /** The board, for other ways of serving it. */
  public IoioFirmware board() {
    return board;
  }

  /** The cable, to simulate a disconnection. */
  public IoioInProcess inProcess() {
    return cable;
  }
}
