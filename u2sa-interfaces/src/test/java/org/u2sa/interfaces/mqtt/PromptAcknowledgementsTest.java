package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketOption;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Acknowledging at once what came, on Linux, which forgets after a while that it is to. */
@EnabledOnOs(OS.LINUX)
class PromptAcknowledgementsTest {
  @Test
  void renew_linuxHasForgotten_isSetAgain() throws IOException {
    InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try (ServerSocketChannel server = ServerSocketChannel.open().bind(any);
        SocketChannel client = SocketChannel.open(server.getLocalAddress());
        SocketChannel accepted = server.accept()) {
      SocketOption<?> quick =
          client.supportedOptions().stream()
              .filter(option -> option.name().equals("TCP_QUICKACK"))
              .findFirst()
              .orElseThrow();
      PromptAcknowledgements acknowledgements = new PromptAcknowledgements(client);
      ByteBuffer answer = ByteBuffer.allocate(1);
      while (isOn(client, quick)) { // a conversation makes Linux acknowledge with the next answer
        client.write(ByteBuffer.allocate(1));
        accepted.read(ByteBuffer.allocate(1));
        accepted.write(ByteBuffer.allocate(1));
        client.read(answer.rewind());
      }
      acknowledgements.renew();

      assertThat(isOn(client, quick)).isTrue();
    }
  }

  private static boolean isOn(SocketChannel client, SocketOption<?> option) throws IOException {
    return Boolean.TRUE.equals(client.getOption(option));
  }
}
