package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.Opcode;

/**
 * Positions listed in a file's summary. They must not overlap: otherwise a small file could list
 * one record thousands of times and exhaust memory with copies.
 */
final class IndexedPlaces {
  private record Place(long offset, long length) {}

  private final List<Place> places = new ArrayList<>();

  void add(long offset, long length) {
    places.add(new Place(offset, length));
  }

  /**
   * Validates all positions.
   *
   * @param dataEnd end of the data section [B]
   * @throws McapException if one is outside the data section, or two overlap
   */
  void require(long dataEnd) throws McapException {
    places.sort(Comparator.comparingLong(Place::offset));
    long end = Opcode.magic().length;
    for (Place place : places) {
      boolean isFree = place.offset >= end && place.length <= dataEnd - place.offset;
      if (!isFree || place.length < Opcode.PREFIX) {
        throw new McapException(
            String.format(
                "the summary names a record at byte %d of %d bytes; expected one of at least %d between bytes %d and %d, overlapping no other",
                place.offset, place.length, Opcode.PREFIX, end, dataEnd));
      }
      end = place.offset + place.length;
    }
  }
}
