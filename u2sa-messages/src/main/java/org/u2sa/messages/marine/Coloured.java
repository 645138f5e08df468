package org.u2sa.messages.marine;

import java.util.Optional;

/** An object painted in one colour. */
public interface Coloured {
  /** The colour; empty if unknown. */
  Optional<Colour> colour();
}
