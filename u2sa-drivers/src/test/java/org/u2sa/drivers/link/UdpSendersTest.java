package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.time.SystemClock;

/** A device at an unknown address, and strangers who send to the same port. */
@Timeout(60)
class UdpSendersTest {
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private DatagramSocket device;
  private DatagramSocket stranger;
  private int port;
  private ByteLink link;

  @BeforeEach
  void plug() throws IOException {
    device = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    try (DatagramSocket free = new DatagramSocket(0)) {
      port = free.getLocalPort();
    }
  }

  @AfterEach
  void end() {
    link.close();
    device.close();
    stranger.close();
  }

  private void open(String options) {
    link = ByteLinks.open("udp:" + port + "?" + options, new SystemClock());
  }

  private void says(DatagramSocket from, String text) throws IOException {
    byte[] bytes = text.getBytes(US_ASCII);
    from.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
  }

  private String heard() {
    byte[] buffer = new byte[256];
    return new String(buffer, 0, link.read(buffer), US_ASCII);
  }

  /** Says it until it is heard: the port may not be open yet. */
  private void isHeard(DatagramSocket from, String text) {
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              says(from, text);
              return heard().contains(text);
            });
  }

  private static String told(DatagramSocket to) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[256], 256);
    to.setSoTimeout((int) PATIENCE.toMillis());
    to.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), US_ASCII);
  }

  private static boolean isTold(DatagramSocket to) throws IOException {
    to.setSoTimeout(300);
    try {
      to.receive(new DatagramPacket(new byte[256], 256));
      return true;
    } catch (SocketTimeoutException e) {
      return false;
    }
  }

  @Test
  void write_strangerSpokeLast_goesToTheDevice() throws IOException {
    open("silence=30");
    isHeard(device, "here");
    for (int i = 0; i < 100; i++) {
      says(stranger, "x");
    }
    says(device, "there");
    await().atMost(PATIENCE).until(() -> heard().endsWith("there")); // the stranger's are read
    for (int i = 0; i < 100; i++) {
      says(stranger, "x");
    }

    assertThat(link.write("stop".getBytes(US_ASCII))).isTrue();

    assertThat(told(device)).isEqualTo("stop");
    assertThat(isTold(stranger)).isFalse();
  }

  @Test
  void read_stranger_isNotHeardWhileTheDeviceSpeaks() throws IOException {
    open("silence=30");
    isHeard(device, "here");
    says(stranger, "forged");
    says(device, "end");

    StringBuilder all = new StringBuilder();
    await().atMost(PATIENCE).until(() -> all.append(heard()).indexOf("end") >= 0);
    assertThat(all.toString()).doesNotContain("forged");
  }

  @Test
  void read_deviceReturnsUnderAnotherAddressAfterASilence_isHeardAgain() throws IOException {
    open("silence=0.3");
    isHeard(device, "before");
    isHeard(stranger, "after");

    assertThat(link.write("you".getBytes(US_ASCII))).isTrue();
    assertThat(told(stranger)).isEqualTo("you");
  }

  @Test
  void read_allSendersWanted_hearsAllAndAnswersTheFirst() throws IOException {
    open("silence=30&senders=all");
    isHeard(device, "one");
    isHeard(stranger, "two");

    assertThat(link.write("you".getBytes(US_ASCII))).isTrue();
    assertThat(told(device)).isEqualTo("you");
  }
}
