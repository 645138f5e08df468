package org.u2sa.control;

import org.u2sa.service.handover.HandOver;

/**
 * Saves or restores the values of a control law at a hot swap (bumpless transfer); a law lists its
 * values once for both.
 */
public final class Transfer {
  private final HandOver state;
  private final boolean isRestoring;

  private Transfer(HandOver state, boolean isRestoring) {
    this.state = state;
    this.isRestoring = isRestoring;
  }

  /** A pass that saves values. */
  public static Transfer saving(HandOver state) {
    return new Transfer(state, false);
  }

  /** A pass that restores values. */
  public static Transfer restoring(HandOver state) {
    return new Transfer(state, true);
  }

  boolean isRestoring() {
    return isRestoring;
  }

  /** Like {@link #number(String, double, double)}, with 0 for an absent value. */
  public double number(String name, double now) {
    return number(name, now, 0.0);
  }

  /**
   * Saves or restores a value; returns the value to continue with.
   *
   * @param now current value, saved unless it is NaN
   * @param ifAbsent value to restore if none was saved
   */
  public double number(String name, double now, double ifAbsent) {
    if (isRestoring) {
      return state.number(name).orElse(ifAbsent);
    }
    state.number(name, now);
    return now;
  }

  /** Saves or restores a flag; returns the flag to continue with, false if none was saved. */
  public boolean flag(String name, boolean now) {
    if (isRestoring) {
      return state.flag(name);
    }
    state.flag(name, now);
    return now;
  }

  /** Saves or restores a constant; returns the one to continue with, or null. */
  public <E extends Enum<E>> E constant(String name, Class<E> type, E now) {
    if (isRestoring) {
      return state.text(name).map(text -> Enum.valueOf(type, text)).orElse(null);
    }
    if (now != null) {
      state.text(name, now.name());
    }
    return now;
  }

  /** Whether an optional group of values follows: present now, or saved under that name. */
  public boolean has(String name, boolean now) {
    return isRestoring ? state.number(name).isPresent() : now;
  }
}
