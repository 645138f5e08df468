package org.u2sa.interfaces.xml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import org.u2sa.interfaces.BadInputException;

/**
 * Reads XML files into {@link XmlElement}s. Hardened against hostile files: no external access, no
 * DTD, only predefined entities; size, depth and file type are limited.
 */
public final class XmlReader {
  private XmlReader() {}

  /**
   * Reads the root element of a file.
   *
   * @throws BadInputException if it is missing, unreadable, invalid, or has another root; names
   *     file, line and expectation
   */
  public static XmlElement read(Path file, String expectedRoot) {
    return XmlText.read(file).root(expectedRoot);
  }

  /**
   * {@link #read(Path, String)} from a stream, which is not closed.
   *
   * @param origin name of the source in messages
   */
  public static XmlElement read(InputStream in, String origin, String expectedRoot) {
    try {
      return XmlText.of(in, origin).root(expectedRoot);
    } catch (IOException e) {
      throw new BadInputException(origin + ": cannot be read: " + e.getMessage(), e);
    }
  }
}
