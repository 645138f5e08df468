package org.u2sa.drivers.link;

/** The device at the far end of a link under test. */
public interface FarEnd {
  /** The link's address; a text that names no thread if it has none. */
  String address();

  /** Opens the link to it. */
  ByteLink open();

  /** Says something. Where a device is found by what it says, it is found by this. */
  void says(String text) throws Exception;

  /** All that it was told so far. */
  String wasTold();

  /** Goes away. */
  void unplug() throws Exception;

  /** Comes back. */
  void plug() throws Exception;

  /** Whether it can be told something. */
  default boolean listens() {
    return true;
  }

  /** Whether it still gets what was written just before the link was closed. */
  default boolean hearsTheLast() {
    return listens();
  }

  /** Frees all that the test took. */
  void end() throws Exception;
}
