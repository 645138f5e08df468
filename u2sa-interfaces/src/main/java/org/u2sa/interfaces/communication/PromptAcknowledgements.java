package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.net.SocketOption;
import java.nio.channels.SocketChannel;
import java.util.Optional;

/**
 * Acknowledges what came at once, where the platform can (Linux). A broker that does not set
 * TCP_NODELAY, as Mosquitto by default, holds its next small packet back until the one before is
 * acknowledged (RFC 896), which otherwise takes up to 40 ms (RFC 1122, 4.2.3.2).
 */
final class PromptAcknowledgements {
  private final SocketChannel channel;
  private final Optional<SocketOption<Boolean>> option;

  PromptAcknowledgements(SocketChannel channel) {
    this.channel = channel;
    option =
        channel.supportedOptions().stream()
            .filter(any -> any.name().equals("TCP_QUICKACK") && any.type() == Boolean.class)
            .findFirst()
            .map(PromptAcknowledgements::ofBoolean);
  }

  @SuppressWarnings("unchecked") // its type was compared
  private static SocketOption<Boolean> ofBoolean(SocketOption<?> any) {
    return (SocketOption<Boolean>) any;
  }

  /** To be called after each reading: Linux forgets it. */
  void renew() throws IOException {
    if (option.isPresent()) {
      channel.setOption(option.get(), true);
    }
  }
}
