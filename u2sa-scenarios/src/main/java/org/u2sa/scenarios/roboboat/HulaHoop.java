package org.u2sa.scenarios.roboboat;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * Shoots darts through a hoop on the shore, whose type is in objectTypes; ends after a number of
 * shots or a time at the station (thesis 4.2.1.3).
 */
public final class HulaHoop extends BoatTask {
  private static final Schema<HulaHoop> SCHEMA =
      Schema.of(HulaHoop.class, HulaHoop::new, BoatTask.TYPE);
  private static final ValueField<HulaHoop, Long> MAX_SHOTS = SCHEMA.optionalCount("maxShots", "");
  private static final NumberField<HulaHoop> MAX_SECONDS =
      SCHEMA.optionalNumber("maxSeconds", "s", 0.0);
  private static final ValueField<HulaHoop, Long> SHOTS = SCHEMA.optionalCount("shots", "");
  private static final NumberField<HulaHoop> SECONDS = SCHEMA.optionalNumber("seconds", "s", 0.0);

  public static final MessageType<HulaHoop> TYPE = SCHEMA.build();

  @Override
  public MessageType<HulaHoop> type() {
    return TYPE;
  }

  /** Shots after which the task ends; defaults to 6. */
  public long maxShots() {
    return optionalCount(MAX_SHOTS).orElse(6L);
  }

  /** Time at the station after which the task ends [s]; defaults to 90. */
  public double maxSeconds() {
    return get(MAX_SECONDS).orElse(90.0);
  }

  /** Shots so far, reported back. */
  public long shots() {
    return optionalCount(SHOTS).orElse(0L);
  }

  /** Time at the station so far [s], reported back. */
  public double seconds() {
    return get(SECONDS).orElse(0.0);
  }

  HulaHoop fired(long shots, double seconds) {
    return put(SHOTS, shots).put(SECONDS, seconds);
  }

  @Override
  public HulaHoop copy() {
    return (HulaHoop) super.copy();
  }
}
