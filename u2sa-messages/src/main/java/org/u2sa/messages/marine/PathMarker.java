package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Rectangle;

/**
 * A flat marker on the floor. Its length axis psi points to the next task; seen from a camera psi
 * is ambiguous by half a turn.
 */
public class PathMarker extends Rectangle implements Coloured {
  private static final Schema<PathMarker> SCHEMA =
      Schema.of(PathMarker.class, PathMarker::new, Rectangle.TYPE).since(3);
  private static final ValueField<PathMarker, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<PathMarker> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PathMarker> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public PathMarker colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public PathMarker length(double value) {
    return (PathMarker) super.length(value);
  }

  @Override
  public PathMarker width(double value) {
    return (PathMarker) super.width(value);
  }

  @Override
  public PathMarker psi(double value) {
    return (PathMarker) super.psi(value);
  }
}
