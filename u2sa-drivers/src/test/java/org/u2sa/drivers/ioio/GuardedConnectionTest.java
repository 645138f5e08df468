package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.InputStream;
import java.io.OutputStream;
import org.junit.jupiter.api.Test;

class GuardedConnectionTest {
  /** A connection that is ended, as by a service that is killed, while it is being made. */
  private static final class EndedMeanwhile implements IOIOConnection {
    private GuardedConnection guarded;

    @Override
    public void waitForConnect() {
      guarded.disconnect();
    }

    @Override
    public void disconnect() {}

    @Override
    public InputStream getInputStream() {
      return InputStream.nullInputStream();
    }

    @Override
    public OutputStream getOutputStream() {
      return OutputStream.nullOutputStream();
    }

    @Override
    public boolean canClose() {
      return true;
    }
  }

  @Test
  void waitForConnect_endedMeanwhile_isLostAndLeavesNoThread() {
    EndedMeanwhile link = new EndedMeanwhile();
    link.guarded = new GuardedConnection(link, false);
    assertThatThrownBy(link.guarded::waitForConnect).isInstanceOf(ConnectionLostException.class);
    LibraryThreads.awaitNone();
  }
}
