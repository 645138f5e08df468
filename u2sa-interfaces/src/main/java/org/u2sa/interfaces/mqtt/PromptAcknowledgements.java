package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.net.SocketOption;
import java.nio.channels.SocketChannel;
import java.util.Optional;

/**
 * Disables delayed TCP acknowledgements (Linux). A broker without TCP_NODELAY, such as Mosquitto by
 * default, holds back a small packet until the previous one is acknowledged (RFC 896), by default
 * up to 40 ms (RFC 1122, 4.2.3.2).
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

  @SuppressWarnings("unchecked") // type checked above
  private static SocketOption<Boolean> ofBoolean(SocketOption<?> any) {
    return (SocketOption<Boolean>) any;
  }

  /** Call after each read, because Linux resets the option. */
  void renew() throws IOException {
    if (option.isPresent()) {
      channel.setOption(option.get(), true);
    }
  }
}
