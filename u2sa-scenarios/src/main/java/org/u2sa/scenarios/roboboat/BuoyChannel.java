package org.u2sa.scenarios.roboboat;

import java.util.OptionalLong;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A channel of gates, each between a buoy to the left and one to the right, to be passed in order
 * (thesis 4.2). The station is its entrance. It ends after a number of gates or at a buoy.
 */
public final class BuoyChannel extends BoatTask {
  private static final Schema<BuoyChannel> SCHEMA =
      Schema.of(BuoyChannel.class, BuoyChannel::new, BoatTask.TYPE);
  private static final ValueField<BuoyChannel, Colour> LEFT =
      SCHEMA.requiredChoice("left", Colour.class);
  private static final ValueField<BuoyChannel, Colour> RIGHT =
      SCHEMA.requiredChoice("right", Colour.class);
  private static final ValueField<BuoyChannel, Colour> END =
      SCHEMA.optionalChoice("endBuoy", Colour.class);
  private static final ValueField<BuoyChannel, Long> GATES = SCHEMA.optionalCount("gates", "");
  private static final NumberField<BuoyChannel> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.1);
  private static final ValueField<BuoyChannel, Long> PASSED = SCHEMA.optionalCount("passed", "");

  public static final MessageType<BuoyChannel> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends BuoyChannel> type() {
    return TYPE;
  }

  /** Colour of the buoys to the left. */
  public Colour left() {
    return require(LEFT);
  }

  /** Colour of the buoys to the right. */
  public Colour right() {
    return require(RIGHT);
  }

  /** Whether the channel ends at a buoy of a distinct colour. */
  public boolean endsAtBuoy() {
    return get(END) != null;
  }

  /** Colour of the buoy at its end. */
  public Colour endBuoy() {
    return require(END);
  }

  /** Gates until its end; empty if it ends at a buoy. */
  public OptionalLong gates() {
    return optionalCount(GATES);
  }

  /** Speed in the channel [m/s]; 1.5 if unset. */
  public double speed() {
    return get(SPEED).orElse(1.5);
  }

  /** Gates passed so far, reported back. */
  public long passed() {
    return optionalCount(PASSED).orElse(0L);
  }

  public BuoyChannel passed(long gates) {
    return put(PASSED, gates);
  }

  @Override
  public BuoyChannel copy() {
    return (BuoyChannel) super.copy();
  }
}
