package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import ioio.lib.api.exception.ConnectionLostException;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.ioio.IoioInProcess;

/**
 * A session that breaks at any byte, in either direction: the pins float, no thread hangs, and the
 * board is back. The library is the unmodified one.
 */
class CutConnectionTest {
  private static final int WHOLE = Integer.MAX_VALUE;
  private static final int LONGEST_SESSION = 400; // bytes, more than are written below
  private static final long STEP_MICROS = 10_000;

  /** Runs one session; returns whether it was long enough to be cut. */
  private static boolean run(int inputBytes, int outputBytes) {
    Bench bench = new Bench();
    bench.pulses(35, 1.9e-3);
    IoioInProcess board = new IoioInProcess(bench.firmware);
    BoardConnection cut =
        new CutConnection(BoardConnectorTest.connection(board), inputBytes, outputBytes);
    String where = "cut after " + inputBytes + " bytes in, " + outputBytes + " out";
    try (BoardConnector connector = new BoardConnector(cut, BoardConnectorTest.PLAN, 1.0)) {
      connector.step(0);
      BoardSession first = connector.session().orElse(null);
      boolean wasCut = false;
      for (long now = STEP_MICROS; now <= 5 * STEP_MICROS; now += STEP_MICROS) {
        wasCut |= !connector.session().filter(session -> drives(session)).isPresent();
        connector.step(now);
      }
      wasCut |= connector.session().orElse(null) != first;
      if (wasCut) {
        assertThat(bench.width(10)).as(where).isZero();
      }
      connector.step(40 * STEP_MICROS);
      connector.step(41 * STEP_MICROS);
      assertThat(connector.session()).as(where).isPresent();
      assertThat(drives(connector.session().orElseThrow())).as(where).isTrue();
      assertThat(bench.width(10)).as(where).isGreaterThan(1.0e-3);
      return wasCut;
    }
  }

  private static boolean drives(BoardSession session) {
    try {
      session.pins().pulse(0, 1.6e-3);
      session.pins().pulse(1, 1.4e-3);
      session.pins().light(true);
      return true;
    } catch (ConnectionLostException e) {
      return false;
    }
  }

  @Test
  void input_cutAtAnyByte_boardIsBack() {
    int cuts = 0;
    for (int bytes = 0; bytes < LONGEST_SESSION && run(bytes, WHOLE); bytes++) {
      cuts++;
    }
    assertThat(cuts).isGreaterThan(100);
    LibraryThreads.awaitNone();
  }

  @Test
  void output_cutAtAnyByte_boardIsBack() {
    int cuts = 0;
    for (int bytes = 0; bytes < LONGEST_SESSION && run(WHOLE, bytes); bytes++) {
      cuts++;
    }
    assertThat(cuts).as("bytes that the host writes in the session").isEqualTo(79);
    LibraryThreads.awaitNone();
  }
}
