package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The places that a file's summary names. Two of them cannot overlap: a small file could otherwise
 * name one record thousands of times, and fill the memory with copies of it.
 */
final class IndexedPlaces {
  private record Place(long offset, long length) {}

  private final List<Place> places = new ArrayList<>();

  void add(long offset, long length) {
    places.add(new Place(offset, length));
  }

  /**
   * Checks them all.
   *
   * @param dataEnd where the data end [B]
   * @throws McapException if one is not within the data, or two overlap
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
