package ioio.lib.spi;

import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Destination of the IOIO library's log messages. The library loads a class of this name at
 * startup; the classes of its Android and desktop parts are not used here. Its messages go to
 * {@code java.util.logging} at detail level, because the service logs everything relevant to a
 * user.
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
