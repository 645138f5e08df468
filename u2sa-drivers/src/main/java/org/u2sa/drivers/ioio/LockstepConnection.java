package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * An in-process board in lockstep, built from functions so that neither it nor the simulator
 * depends on the other:
 *
 * <pre>{@code
 * new LockstepConnection(board::connect, board::disconnect, board::input, board::output, board::exchange)
 * }</pre>
 */
public final class LockstepConnection implements BoardConnection {
  /** See {@link BoardConnection#exchange}. */
  @FunctionalInterface
  public interface Exchange {
    void exchange(long nowMicros, Consumer<byte[]> reader);
  }

  private final BooleanSupplier connect;
  private final Runnable disconnect;
  private final Supplier<InputStream> input;
  private final Supplier<OutputStream> output;
  private final Exchange exchange;

  /**
   * @param connect opens a connection; false if the board is off
   * @param disconnect ends it
   * @param input bytes from the board on the latest connection
   * @param output bytes to the board on the latest connection; never blocks
   * @param exchange see {@link BoardConnection#exchange}
   */
  public LockstepConnection(
      BooleanSupplier connect,
      Runnable disconnect,
      Supplier<InputStream> input,
      Supplier<OutputStream> output,
      Exchange exchange) {
    this.connect = connect;
    this.disconnect = disconnect;
    this.input = input;
    this.output = output;
    this.exchange = exchange;
  }

  @Override
  public String address() {
    return "this process";
  }

  @Override
  public boolean isLockstep() {
    return true;
  }

  @Override
  public void exchange(long nowMicros, Consumer<byte[]> reader) {
    exchange.exchange(nowMicros, reader);
  }

  @Override
  public IOIOConnection newConnection() {
    return new IOIOConnection() {
      private InputStream in;
      private OutputStream out;

      @Override
      public void waitForConnect() throws ConnectionLostException {
        if (!connect.getAsBoolean()) {
          throw new ConnectionLostException(new IllegalStateException("the board has no power"));
        }
        in = input.get();
        out = output.get();
      }

      @Override
      public void disconnect() {
        if (in != null) {
          disconnect.run();
        }
      }

      @Override
      public InputStream getInputStream() {
        return in;
      }

      @Override
      public OutputStream getOutputStream() {
        return out;
      }

      @Override
      public boolean canClose() {
        return true;
      }
    };
  }
}
