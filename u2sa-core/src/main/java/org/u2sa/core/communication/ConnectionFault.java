package org.u2sa.core.communication;

import io.netty.handler.codec.DecoderException;
import io.netty.handler.ssl.NotSslRecordException;
import java.io.IOException;
import javax.net.ssl.SSLHandshakeException;
import org.u2sa.core.communication.access.Refusals;

/**
 * Reason for a failed connection.
 *
 * @param kind the counter
 * @param words message of the network code, sanitised for a log line
 * @param isLoss whether the peer has gone, as when its process was killed or interrupted
 */
record ConnectionFault(String kind, String words, boolean isLoss) {
  static final String MALFORMED = "malformed packet";

  static ConnectionFault of(Throwable error) {
    for (Throwable cause = error; cause != null; cause = cause.getCause()) {
      if (cause instanceof SSLHandshakeException || cause instanceof NotSslRecordException) {
        return told("connection without the right encryption", cause);
      }
    }
    if (error instanceof DecoderException) {
      return told(MALFORMED, error);
    }
    return error instanceof IOException
            && error.getCause() != null // Moquette wraps decoder exceptions
        ? told(MALFORMED, error.getCause())
        : new ConnectionFault("connection failed", shown(error), error instanceof IOException);
  }

  private static ConnectionFault told(String kind, Throwable cause) {
    return new ConnectionFault(kind, shown(cause), false);
  }

  private static String shown(Throwable cause) {
    return Refusals.shown(String.valueOf(cause.getMessage()));
  }
}
