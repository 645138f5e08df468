package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Box;

/**
 * A coloured bin on the floor that markers are dropped into (thesis 4.3); the drop zone is its top
 * face.
 */
public class Bin extends Box implements Coloured {
  private static final Schema<Bin> SCHEMA = Schema.of(Bin.class, Bin::new, Box.TYPE).since(3);
  private static final ValueField<Bin, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Bin> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Bin> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Bin colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public Bin length(double value) {
    return (Bin) super.length(value);
  }

  @Override
  public Bin width(double value) {
    return (Bin) super.width(value);
  }

  @Override
  public Bin height(double value) {
    return (Bin) super.height(value);
  }

  @Override
  public Bin psi(double value) {
    return (Bin) super.psi(value);
  }
}
