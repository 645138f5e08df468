package org.u2sa.core.safety;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * The previous Safety Manager of the same run, so that a restart in flight neither disarms the
 * vehicle nor drops a failsafe. Its failsafes are known from its saved state. Its last retained
 * message proves only that one ran recently enough for this to be a restart, because others could
 * have published the message. It counts alone only if this is a restart within the run and the
 * saved state is lost, as on a full disk: an aircraft must not be disarmed in the air.
 */
final class Predecessor {
  private static final double LISTEN_S = 0.5; // time for a broker to send retained messages
  private static final double SPOKE_WITHIN_S = 20.0;

  /**
   * The same for one restarted within the run: 10 s to notice, then three starts that hang for 15 s
   * each, delays, and retries for lack of resources. Limited, because a manual restart must not
   * re-arm a vehicle that has come down by then.
   */
  private static final double SPOKE_BEFORE_RESTART_WITHIN_S = 120.0;

  private static final String ARMED = "armed";

  private final long listensUntilMicros;
  private final double spokeWithinS;
  private final boolean isRestart;
  private boolean isStateKnown; // whether its saved state was found
  private boolean awaited = true;
  private boolean heard; // whether it sent a message
  private boolean saysArmed; // according to its last message
  private long saidMicros = Long.MIN_VALUE; // timestamp of that message
  private boolean armed; // according to its saved state

  Predecessor(long nowMicros, boolean isRestart) {
    this.isRestart = isRestart;
    spokeWithinS = isRestart ? SPOKE_BEFORE_RESTART_WITHIN_S : SPOKE_WITHIN_S;
    listensUntilMicros = nowMicros + Clock.micros(LISTEN_S);
  }

  /** Saves the state of the present Safety Manager for its successor. */
  static void handOver(HandOver state, boolean armed) {
    state.flag(ARMED, armed);
  }

  /** Passes its state to the next successor, which starts before this one has begun. */
  void handOver(HandOver state) {
    handOver(state, armed || wasArmed());
  }

  /** Restores the state saved by {@link #handOver}. */
  void takeOver(HandOver state) {
    armed = state.flag(ARMED);
    isStateKnown = true;
  }

  void see(U2SAData message, long nowMicros) {
    long ageMicros = nowMicros - message.timestamp().orElse(Long.MIN_VALUE / 2);
    if (awaited
        && message instanceof ArmingState state
        && Math.abs(ageMicros) <= Clock.micros(spokeWithinS)) {
      heard = true;
      saysArmed = state.armed();
      saidMicros = nowMicros - ageMicros;
    }
  }

  /** Whether its messages may still arrive. */
  boolean isAwaited(long nowMicros) {
    awaited &= nowMicros < listensUntilMicros;
    return awaited;
  }

  /** Ignores it from now on. */
  void end() {
    awaited = false;
    armed = false;
    saysArmed = false;
  }

  /** Whether a Safety Manager was active shortly before. */
  boolean wasHeard() {
    return heard;
  }

  boolean wasArmed() {
    return saysArmed && (armed || isStateLost());
  }

  /** Whether its saved state is missing, so that only its retained messages are known. */
  boolean isStateLost() {
    return isRestart && !isStateKnown;
  }

  /** Whether its last arming state was published after that time [µs of the run's clock]. */
  boolean spokeAfter(long micros) {
    return saidMicros > micros;
  }
}
