package org.u2sa.interfaces.xml;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import org.u2sa.interfaces.BadInputException;

/**
 * Reads XML files into {@link XmlElement}s. Safe against hostile files: nothing outside of the file
 * is read or asked, no DTD, no entities beside XML's own; bounded size, depth and kind of file.
 */
public final class XmlReader {
  private static final int CHUNK = 8192;

  private XmlReader() {}

  /**
   * The root element of a file.
   *
   * @param expectedRoot the name that it must have
   * @throws BadInputException if the file is missing, unreadable or not such XML; names file, line
   *     and what was expected
   */
  public static XmlElement read(Path file, String expectedRoot) {
    return XmlText.read(file).root(expectedRoot);
  }

  /**
   * The root element of a stream, which is read to its end and not closed.
   *
   * @param origin how messages name the source
   * @throws BadInputException as {@link #read(Path, String)}
   */
  public static XmlElement read(InputStream in, String origin, String expectedRoot) {
    try {
      return XmlText.of(bytes(in), origin).root(expectedRoot);
    } catch (IOException e) {
      throw new BadInputException(origin + ": cannot be read: " + e.getMessage(), e);
    }
  }

  /** What the stream holds, up to a little more than may be read: it may have grown, or no end. */
  static byte[] bytes(InputStream in) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    byte[] chunk = new byte[CHUNK];
    for (int n = in.read(chunk); n >= 0 && bytes.size() <= XmlText.MAX_BYTES; n = in.read(chunk)) {
      bytes.write(chunk, 0, n);
    }
    return bytes.toByteArray();
  }
}
