package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.drivers.link.ByteParser;

/** Makes headings of a compass's bytes. */
public interface CompassParser extends ByteParser {
  /** The newest heading; empty before the first. A new object for each, the same until the next. */
  Optional<Heading> latest();
}
