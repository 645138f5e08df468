package org.u2sa.gcs.mavlink;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.channels.Selector;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
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

  /** Takes turns at a standing clock until the kernel has delivered what the condition needs. */
  private void turnUntil(TcpLink link, Callable<Boolean> condition) {
    await()
        .pollInSameThread()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(1))
        .until(
            () -> {
              turn(link, 0.0);
              return condition.call();
            });
  }

  /** Connects a station, and returns its session. */
  private StationSession connect(TcpLink link, List<Socket> sockets) throws IOException {
    Set<StationSession> before = known(link);
    sockets.add(new Socket(InetAddress.getLoopbackAddress(), link.port()));
    turnUntil(link, () -> !before.containsAll(known(link)));
    Set<StationSession> after = known(link);
    after.removeAll(before);
    return after.iterator().next();
  }

  private static Set<StationSession> known(TcpLink link) {
    Set<StationSession> all = new HashSet<>();
    link.sessions().forEach(all::add);
    return all;
  }

  @Test
  void exchange_severalStations_eachHasItsTelemetryAndTooManyAreClosed() throws IOException {
    byte[] ask = kit.station.encode(StationPackets.requestVersion());
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      for (int i = 0; i < 16; i++) {
        StationSession session = connect(link, sockets);
        sockets.get(i).getOutputStream().write(ask);
        turnUntil(link, session::isHeard);
      }
      Socket tooMany = new Socket(InetAddress.getLoopbackAddress(), link.port());
      tooMany.setSoTimeout(1);
      turnUntil(link, () -> isAtEnd(tooMany));
      assertThat(link.sessions()).hasSize(16);
      turn(link, 1.0);
      turn(link, 0.0);
      for (Socket socket : sockets) {
        assertThat(socket.getInputStream().read()).isEqualTo(0xFD);
        socket.close();
      }
      tooMany.close();
    }
  }

  /** As a page in a browser sends it, without asking. */
  @Test
  void exchange_httpRequestWithPacketsInItsBody_isDisconnectedUnheard() throws IOException {
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      StationSession session = connect(link, sockets);
      ByteArrayOutputStream request = new ByteArrayOutputStream();
      request.writeBytes("POST / HTTP/1.1\r\n\r\n".getBytes(US_ASCII));
      request.writeBytes(kit.station.encode(StationPackets.requestVersion()));
      sockets.get(0).getOutputStream().write(request.toByteArray());
      turnUntil(link, () -> known(link).isEmpty());

      assertThat(session.isHeard()).isFalse();
      sockets.get(0).close();
    }
  }

  private static boolean isAtEnd(Socket socket) throws IOException {
    try {
      return socket.getInputStream().read() < 0;
    } catch (SocketTimeoutException e) {
      return false; // nothing more has come yet
    }
  }

  @Test
  void exchange_allPlacesTakenWithoutTheKey_aStationComesInsteadOfTheOldest() throws IOException {
    MavlinkStream keyed = new MavlinkStream(255, 190, Optional.of(signing()));
    try (Selector selector = Selector.open();
        TcpLink link = open(selector, Optional.of(signing()))) {
      List<Socket> sockets = new ArrayList<>();
      StationSession first = connect(link, sockets);
      sockets.get(0).getOutputStream().write(keyed.encode(StationPackets.requestVersion()));
      turnUntil(link, first::isHeard);
      List<StationSession> others = new ArrayList<>();
      for (int i = 1; i < 16; i++) {
        others.add(connect(link, sockets));
        sockets.get(i).getOutputStream().write(kit.station.encode(StationPackets.requestVersion()));
      }
      StationSession last = connect(link, sockets);
      assertThat(known(link)).hasSize(16).contains(first, last).doesNotContain(others.get(0));
      assertThat(known(link)).containsAll(others.subList(1, 15));
      assertThat(sockets.get(1).getInputStream().readAllBytes()).isNotNull(); // returns at its end
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  private MavlinkSigning signing() {
    return new MavlinkSigning("open sesame", kit.clock::get);
  }

  @Test
  void exchange_flood_isHandledAtTheAllowedRateOnly() throws IOException {
    byte[] ask = kit.station.encode(StationPackets.requestVersion());
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      connect(link, sockets);
      Socket socket = sockets.get(0);
      int handled = 0;
      for (int second = 0; second < 10; second++) {
        for (int i = 0; i < 10; i++) {
          socket.getOutputStream().write(many(ask, 200));
          turn(link, 0.1);
          handled += acknowledged(socket.getInputStream());
        }
      }
      assertThat(handled).isBetween(500, 900 + 10 * 240 + 500); // of 20,000 sent
      socket.close();
    }
  }

  /** As sticks for seconds in one burst: what follows must not wait behind them. */
  @Test
  void exchange_afterAFlood_handlesWhatComesNextAtOnce() throws IOException {
    byte[] ask = kit.station.encode(StationPackets.requestVersion());
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      connect(link, sockets);
      Socket socket = sockets.get(0);
      for (int i = 0; i < 20; i++) {
        socket.getOutputStream().write(many(ask, 300));
        turn(link, 0.0);
      }
      int late = 0;
      for (int i = 0; i < 20; i++) { // a second, in which 230 packets of a backlog were read
        turn(link, 0.05);
        int handled = acknowledged(socket.getInputStream());
        late += i < 5 ? 0 : handled;
      }
      assertThat(late).isLessThan(50);

      socket.getOutputStream().write(ask);
      turnUntil(link, () -> acknowledged(socket.getInputStream()) > 0);
      socket.close();
    }
  }

  @Test
  void exchange_onlyFalseStartsOfPackets_isReadNoFurtherThanMessages() throws IOException {
    byte[] starts = new byte[64 * 1024];
    Arrays.fill(starts, (byte) 0xFE); // each begins a DEBUG message whose checksum is wrong
    try (Selector selector = Selector.open();
        TcpLink link = open(selector)) {
      List<Socket> sockets = new ArrayList<>();
      StationSession session = connect(link, sockets);
      try (Socket socket = sockets.get(0)) {
        socket.getOutputStream().write(starts);
        turnUntil(link, () -> !session.isOpen(kit.clock.get()));
      }
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
