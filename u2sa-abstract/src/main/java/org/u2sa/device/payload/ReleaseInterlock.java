package org.u2sa.device.payload;

import org.u2sa.interfaces.time.Clock;

/**
 * Guards a release against accidental commands. It fires once, after this sequence: the vehicle is
 * armed without an emergency stop, then the safe position is commanded, then the release without
 * interruption for the hold time. Not thread-safe.
 */
final class ReleaseInterlock {
  /** The commanded state. */
  enum Wanted {
    NOTHING,
    SAFE,
    RELEASE
  }

  private enum State {
    LOCKED,
    READY,
    HELD,
    FIRING
  }

  private final long holdMicros;
  private final long fireMicros;
  private State state = State.LOCKED;
  private long sinceMicros;

  /**
   * @param holdS how long the release must be commanded before it fires [s]
   * @param fireS how long it fires, while it is commanded [s]
   */
  ReleaseInterlock(double holdS, double fireS) {
    holdMicros = Clock.micros(holdS);
    fireMicros = Clock.micros(fireS);
  }

  /** Forgets all commands. */
  void lock() {
    state = State.LOCKED;
  }

  /**
   * Whether it fires now; call it at each step.
   *
   * @param mayFire whether the vehicle is armed and has no emergency stop
   */
  boolean fires(Wanted wanted, boolean mayFire, long nowMicros) {
    if (!mayFire || wanted == Wanted.NOTHING) {
      lock();
    } else if (wanted == Wanted.SAFE) {
      state = State.READY;
    } else if (state == State.READY) {
      become(State.HELD, nowMicros);
    } else if (state == State.HELD && nowMicros - sinceMicros >= holdMicros) {
      become(State.FIRING, nowMicros);
    } else if (state == State.FIRING && nowMicros - sinceMicros >= fireMicros) {
      lock();
    }
    return state == State.FIRING;
  }

  /**
   * Whether a release commanded now cannot fire, because the safe position was not commanded first.
   */
  boolean isLocked() {
    return state == State.LOCKED;
  }

  private void become(State next, long nowMicros) {
    state = next;
    sinceMicros = nowMicros;
  }
}
