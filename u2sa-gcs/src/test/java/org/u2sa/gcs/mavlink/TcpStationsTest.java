package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;

/** Stations by TCP: what they get, and that a flood of one is read slowly. */
class TcpStationsTest {
  private final BridgeKit kit = BridgeKit.rover().ready();

  private void turn(TcpLink link, double seconds) throws IOException {
    kit.clock.addAndGet(Math.round(seconds * 1e6));
    link.sessions().forEach(session -> session.step(kit.clock.get()));
    link.exchange(kit.clock.get());
  }

  @Test
  void exchange_severalStations_eachHasItsTelemetryAndTooManyAreClosed() throws IOException {
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      for (int i = 0; i < 17; i++) {
        sockets.add(new Socket(InetAddress.getLoopbackAddress(), link.port()));
        if (i < 16) {
          byte[] ask = kit.station.encode(StationPackets.requestVersion());
          sockets.get(i).getOutputStream().write(ask);
        }
        turn(link, 0.1);
        turn(link, 0.1);
      }
      assertThat(link.sessions()).hasSize(16);
      turn(link, 1.0);
      for (Socket socket : sockets.subList(0, 16)) {
        assertThat(socket.getInputStream().read()).isEqualTo(0xFD);
      }
      assertThat(sockets.get(16).getInputStream().read()).isEqualTo(-1);
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  @Test
  void exchange_allPlacesTakenWithoutTheKey_aStationComesInsteadOfTheOldest() throws IOException {
    MavlinkStream keyed = new MavlinkStream(255, 190, Optional.of(signing()));
    try (Selector selector = Selector.open();
        TcpLink link = open(selector, Optional.of(signing()))) {
      List<Socket> sockets = new ArrayList<>();
      for (int i = 0; i < 17; i++) {
        sockets.add(new Socket(InetAddress.getLoopbackAddress(), link.port()));
        MavlinkStream sender = i == 0 || i == 16 ? keyed : kit.station;
        sockets.get(i).getOutputStream().write(sender.encode(StationPackets.requestVersion()));
        turn(link, 0.1);
        turn(link, 0.1);
      }
      assertThat(link.sessions()).hasSize(16);
      assertThat(isOpen(sockets.get(0))).isTrue(); // has the key
      assertThat(isOpen(sockets.get(1))).isFalse();
      assertThat(isOpen(sockets.get(2))).isTrue();
      assertThat(isOpen(sockets.get(16))).isTrue();
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  private static boolean isOpen(Socket socket) throws IOException {
    InputStream in = socket.getInputStream();
    in.skipNBytes(in.available());
    socket.setSoTimeout(1);
    try {
      return in.read() >= 0;
    } catch (SocketTimeoutException e) {
      return true; // nothing more has come
    }
  }

  private MavlinkSigning signing() {
    return new MavlinkSigning("open sesame", kit.clock::get);
  }

  @Test
  void exchange_flood_isHandledAtTheAllowedRateOnly() throws IOException {
    byte[] ask = kit.station.encode(StationPackets.requestVersion());
    try (Selector selector = Selector.open();
        TcpLink link = open(selector);
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), link.port())) {
      turn(link, 0.0);
      StationSession session = link.sessions().iterator().next();
      int handled = 0;
      for (int second = 0; second < 10; second++) {
        for (int i = 0; i < 10; i++) {
          socket.getOutputStream().write(many(ask, 200));
          turn(link, 0.1);
          handled += acknowledged(socket.getInputStream());
        }
      }
      assertThat(handled).isBetween(500, 900 + 10 * 240 + 500); // of 20,000 sent
      assertThat(session.allowance(kit.clock.get())).isLessThan(4096);
    }
  }

  @Test
  void exchange_onlyFalseStartsOfPackets_isReadNoFurtherThanMessages() throws IOException {
    byte[] starts = new byte[64 * 1024];
    Arrays.fill(starts, (byte) 0xFE); // each begins a DEBUG message whose checksum is wrong
    try (Selector selector = Selector.open();
        TcpLink link = open(selector);
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), link.port())) {
      turn(link, 0.0);
      StationSession session = link.sessions().iterator().next();
      socket.getOutputStream().write(starts);
      turn(link, 0.1);
      assertThat(session.allowance(kit.clock.get())).isNegative();
    }
  }

  private TcpLink open(Selector selector) throws IOException {
    return open(selector, Optional.empty());
  }

  private TcpLink open(Selector selector, Optional<MavlinkSigning> signing) throws IOException {
    return new TcpLink(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        () -> new StationSession(kit.vehicle, signing),
        selector);
  }

  private static byte[] many(byte[] packet, int times) {
    byte[] all = new byte[packet.length * times];
    for (int i = 0; i < times; i++) {
      System.arraycopy(packet, 0, all, i * packet.length, packet.length);
    }
    return all;
  }

  private int acknowledged(InputStream in) throws IOException {
    byte[] bytes = in.readNBytes(in.available());
    return StationPackets.acknowledgements(bytes);
  }
}
