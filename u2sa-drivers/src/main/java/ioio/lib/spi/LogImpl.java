package ioio.lib.spi;

import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Where the IOIO library's own messages go. The library looks for a class of this name and does not
 * start without one; those of its Android and desktop parts are not used here. Its messages go to
 * {@code java.util.logging} as details, because what matters to a user the service says itself.
 */
public final class LogImpl implements Log.ILogger {
  private static final Logger LOGGER = Logger.getLogger("ioio");

  /** Called by the library, by its name. */
  public LogImpl() {}

  @Override
  public void write(int level, String tag, String message) {
    LOGGER.log(
        level >= Log.WARN ? Level.FINE : Level.FINER, "{0}: {1}", new Object[] {tag, message});
  }
}
