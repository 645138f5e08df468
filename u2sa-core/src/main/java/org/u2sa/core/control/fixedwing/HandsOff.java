package org.u2sa.core.control.fixedwing;

/** The Cessna's controls when nobody commands them, where zero would not do. */
public final class HandsOff {
  /**
   * Elevator at which the aircraft holds about 75 kt by itself, with cruise power as at idle [%],
   * negative: nose up. What a pilot would have trimmed. Centred it noses over: nobody cruises with
   * the trim of a dive, and a silence of a few seconds would cost a hundred metres.
   */
  public static final double ELEVATOR_PERCENT = -10.0;

  private HandsOff() {}
}
