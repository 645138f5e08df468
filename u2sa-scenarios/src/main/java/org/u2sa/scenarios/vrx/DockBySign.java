package org.u2sa.scenarios.vrx;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * Docks in the bay whose sign a light buoy encodes: enters, stays for a while, and leaves in
 * reverse. The first colour of the sequence is the sign's colour; the last one encodes its shape
 * (osrf/vrx, issue 278, and the worlds of 2023).
 */
public final class DockBySign extends GoalInformation {
  private static final Schema<DockBySign> SCHEMA =
      Schema.of(DockBySign.class, DockBySign::new, GoalInformation.TYPE);
  private static final NumberField<DockBySign> DURATION =
      SCHEMA.requiredNumber("duration", "s", 0.0, 3600.0);
  private static final ValueField<DockBySign, List<String>> SEQUENCE = SCHEMA.texts("sequence");

  public static final MessageType<DockBySign> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends DockBySign> type() {
    return TYPE;
  }

  /** Time to stay in the bay [s]. */
  public double duration() {
    return require(DURATION);
  }

  public DockBySign duration(double seconds) {
    return put(DURATION, seconds);
  }

  /** Colours of the light buoy; empty until they have been read. */
  public List<Colour> sequence() {
    return get(SEQUENCE).stream().map(Colour::valueOf).collect(Collectors.toUnmodifiableList());
  }

  public DockBySign sequence(List<Colour> colours) {
    return put(
        SEQUENCE, colours.stream().map(Colour::name).collect(Collectors.toUnmodifiableList()));
  }

  /** Type of the sign encoded by the sequence, such as "red circle". */
  public String sign() {
    List<Colour> colours = sequence();
    String shape =
        switch (colours.get(colours.size() - 1)) {
          case RED -> "circle";
          case GREEN -> "triangle";
          case BLUE -> "cross";
          default -> "rectangle"; // yellow
        };
    return colours.get(0).name().toLowerCase(Locale.ROOT) + " " + shape;
  }

  @Override
  public DockBySign copy() {
    return (DockBySign) super.copy();
  }
}
