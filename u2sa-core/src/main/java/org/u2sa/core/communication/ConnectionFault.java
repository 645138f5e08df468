package org.u2sa.core.communication;

import io.netty.handler.codec.DecoderException;
import io.netty.handler.ssl.NotSslRecordException;
import java.io.IOException;
import javax.net.ssl.SSLHandshakeException;

/**
 * Why a connection failed.
 *
 * @param kind the counter
 * @param words what the network code said, sanitised for a log line
 */
record ConnectionFault(String kind, String words) {
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
    return error instanceof IOException && error.getCause() != null // Moquette wraps the decoder's
        ? told(MALFORMED, error.getCause())
        : told("connection failed", error);
  }

  private static ConnectionFault told(String kind, Throwable cause) {
    return new ConnectionFault(kind, Refusals.shown(String.valueOf(cause.getMessage())));
  }
}
