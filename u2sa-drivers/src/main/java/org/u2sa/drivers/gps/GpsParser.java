package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.drivers.link.ByteParser;

/** Makes fixes of a receiver's bytes. */
public interface GpsParser extends ByteParser {
  /** The newest fix; empty before the first. A new object for each fix, the same until the next. */
  Optional<GpsFix> latest();
}
