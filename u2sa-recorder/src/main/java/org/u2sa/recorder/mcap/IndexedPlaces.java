package org.u2sa.recorder.mcap;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The places that a file's summary names. Two of them cannot overlap: a small file could otherwise
 * name one record thousands of times, and fill the memory with copies of it.
 */
final class IndexedPlaces {
  private record Place(long offset, long length) {
    long end() {
      return offset + length;
    }
  }

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
      if (place.length < Opcode.PREFIX || place.length > dataEnd || place.offset > dataEnd) {
        throw new McapException(
            "the summary names a record at byte "
                + place.offset
                + " of "
                + place.length
                + " bytes; expected one before byte "
                + dataEnd);
      }
      if (place.offset < end || place.end() > dataEnd) {
        throw new McapException(
            "the summary names a record at bytes "
                + place.offset
                + " to "
                + place.end()
                + "; expected one between bytes "
                + end
                + " and "
                + dataEnd
                + ", overlapping no other");
      }
      end = place.end();
    }
  }
}
