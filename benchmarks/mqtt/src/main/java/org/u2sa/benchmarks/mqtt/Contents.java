package org.u2sa.benchmarks.mqtt;

import java.nio.ByteBuffer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.StateInformation;

/** What is sent: bytes that open with the time of sending, or a state that has it as x. */
final class Contents {
  private static final double NANOS_PER_S = 1e9; // x has a range: times are in seconds

  static final String SYSTEM = "benchmark";
  private static final int NUMBERS_BYTES = 40; // of a state besides the filling text
  private static final SystemClock CLOCK = new SystemClock();

  private Contents() {}

  /** Each message matters, or none does: no source is like another, so that none is replaced. */
  static Channel<StateInformation> channel(int quality) {
    return quality == 1
        ? Channel.every("benchmark-every", StateInformation.TYPE)
        : Channel.latest(
            "benchmark", StateInformation.TYPE, state -> String.valueOf(state.x().orElse(0)));
  }

  static byte[] bytes(int length, long sentNanos) {
    return ByteBuffer.allocate(length).putLong(sentNanos).array();
  }

  static long sentNanos(ByteBuffer bytes) {
    return bytes.getLong(0);
  }

  /** Texts have a limit of 64 KiB; the rest is the state's numbers. */
  static String filling(int bytes) {
    return "x".repeat(Math.max(1, bytes - NUMBERS_BYTES));
  }

  static StateInformation state(String filling, long sentNanos) {
    return new StateInformation().sensorName(filling).x(sentNanos / NANOS_PER_S).y(1.0);
  }

  static StateInformation frozen(String filling, long sentNanos) {
    StateInformation state = state(filling, sentNanos);
    state.systemId(SYSTEM);
    state.timestamp(CLOCK.micros());
    state.freeze();
    return state;
  }

  static long sentNanos(StateInformation state) {
    return Math.round(NANOS_PER_S * state.x().orElseThrow()); // exact up to 2^53 ns
  }
}
