package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.Random;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.communication.TestAuthority;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.time.SystemClock;

/** TLS against Java's own server sockets, through networks that tear records apart. */
@Timeout(60)
class TlsChannelTest {
  private static final int BYTES = 1_000_000;
  private static final char[] PASSWORD = "changeit".toCharArray();

  @TempDir static Path folder;
  private static SecurityDirectory authority;

  private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
  private final Selector selector = Selector.open();
  private SocketChannel socket;

  TlsChannelTest() throws IOException {}

  @BeforeAll
  static void makeAuthority() throws Exception {
    authority = TestAuthority.in(folder);
  }

  @BeforeEach
  void connect() throws IOException {
    socket =
        SocketChannel.open(new InetSocketAddress(server.getInetAddress(), server.getLocalPort()));
    socket.configureBlocking(false);
    socket.register(selector, SelectionKey.OP_READ);
  }

  @AfterEach
  void close() throws IOException {
    socket.close();
    selector.close();
    server.close();
  }

  private static SSLContext serverContext() throws GeneralSecurityException, IOException {
    KeyStore keys = KeyStore.getInstance(folder.resolve("test.p12").toFile(), PASSWORD);
    KeyManagerFactory managers =
        KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
    managers.init(keys, PASSWORD);
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(managers.getKeyManagers(), null, null);
    return context;
  }

  /** The server's side, whose socket reads and writes through the test's network. */
  private static SSLSocket tls(Socket network) throws GeneralSecurityException, IOException {
    SSLSocket tls =
        (SSLSocket)
            serverContext()
                .getSocketFactory()
                .createSocket(network, "client", network.getPort(), true);
    tls.setUseClientMode(false);
    return tls;
  }

  private TlsChannel channel(SSLContext trusted, String host, String protocol) {
    SSLEngine engine = new PromptTlsSockets(trusted).engine(host, server.getLocalPort());
    engine.setEnabledProtocols(new String[] {protocol});
    return new TlsChannel(socket, engine);
  }

  private TlsChannel channel() throws GeneralSecurityException, IOException {
    return channel(TestAuthority.trusting(authority), "localhost", "TLSv1.3");
  }

  private void shakeHands(TlsChannel channel) throws IOException {
    channel.shakeHands(selector, new SystemClock(), 20_000);
  }

  private interface Work {
    void with(Socket accepted) throws Exception;
  }

  /** Does this with the first connection. A failure ends the connection, which the test notices. */
  private void serve(Work work) {
    Thread thread =
        new Thread(
            () -> {
              try (Socket accepted = server.accept()) {
                work.with(accepted);
              } catch (Exception e) {
                return;
              }
            },
            "test-server");
    thread.setDaemon(true);
    thread.start();
  }

  /** Passes bytes on in pieces of random length. */
  private static void tear(InputStream from, OutputStream to, int longest) {
    Thread thread =
        new Thread(
            () -> {
              Random random = new Random(longest);
              byte[] piece = new byte[longest];
              try {
                int count = from.read(piece, 0, 1 + random.nextInt(longest));
                while (count >= 0) {
                  to.write(piece, 0, count);
                  count = from.read(piece, 0, 1 + random.nextInt(longest));
                }
              } catch (IOException e) {
                return; // the test is over
              }
            },
            "test-network");
    thread.setDaemon(true);
    thread.start();
  }

  private static byte[] random(int bytes) {
    byte[] content = new byte[bytes];
    new Random(1).nextBytes(content);
    return content;
  }

  private int readSome(TlsChannel channel, ByteBuffer to) throws IOException {
    if (!channel.hasUnread()) {
      selector.select();
      selector.selectedKeys().clear();
    }
    return channel.read(to);
  }

  @ParameterizedTest
  @CsvSource({"TLSv1.3,1", "TLSv1.3,700", "TLSv1.3,40000", "TLSv1.2,700"})
  void readAndWrite_recordsTornApart_arriveWholeBothWays(String protocol, int maxPieceLength)
      throws Exception {
    int bytes = maxPieceLength == 1 ? BYTES / 20 : BYTES;
    byte[] content = random(bytes);
    ServerSocket behind = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    serve(
        accepted -> {
          Socket network = new Socket(behind.getInetAddress(), behind.getLocalPort());
          tear(accepted.getInputStream(), network.getOutputStream(), maxPieceLength);
          tear(network.getInputStream(), accepted.getOutputStream(), maxPieceLength);
          SSLSocket tls = tls(behind.accept());
          byte[] heard = new byte[bytes];
          new DataInputStream(tls.getInputStream()).readFully(heard);
          tls.getOutputStream().write(heard);
          tls.getInputStream().read(); // stays until the client has read all
        });
    TlsChannel channel = channel(TestAuthority.trusting(authority), "localhost", protocol);
    shakeHands(channel);

    ByteBuffer out = ByteBuffer.wrap(content);
    ByteBuffer in = ByteBuffer.allocate(bytes);
    while (in.hasRemaining()) {
      channel.write(out);
      if (!out.hasRemaining() && !channel.hasUnsent()) {
        assertThat(readSome(channel, in)).isNotNegative();
      }
    }

    assertThat(in.array()).isEqualTo(content);
    behind.close();
  }

  @Test
  void read_smallBuffer_tellsOfTheRestThatNoSelectorAnnounces() throws Exception {
    byte[] content = random(10_000);
    serve(
        accepted -> {
          SSLSocket tls = tls(accepted);
          tls.getOutputStream().write(content);
          tls.getInputStream().read();
        });
    TlsChannel channel = channel();
    shakeHands(channel);
    ByteBuffer in = ByteBuffer.allocate(content.length);
    in.limit(100);
    while (in.position() == 0) {
      readSome(channel, in);
    }

    assertThat(channel.hasUnread()).isTrue();
    in.limit(in.capacity());
    channel.read(in);

    assertThat(in.array()).isEqualTo(content);
  }

  @Test
  void read_serverEnds_isTheEnd() throws Exception {
    serve(accepted -> tls(accepted).startHandshake());
    TlsChannel channel = channel();
    shakeHands(channel);

    int read = 0;
    while (read == 0) {
      read = readSome(channel, ByteBuffer.allocate(100));
    }

    assertThat(read).isEqualTo(-1);
  }

  @Test
  void shakeHands_certificateOfAnotherAuthority_isNotTrusted() throws Exception {
    serve(accepted -> tls(accepted).startHandshake());
    TlsChannel channel = channel(SSLContext.getDefault(), "localhost", "TLSv1.3");

    assertThatThrownBy(() -> shakeHands(channel)).isInstanceOf(SSLException.class);
  }

  @Test
  void shakeHands_certificateOfAnotherHost_isNotTrusted() throws Exception {
    serve(accepted -> tls(accepted).startHandshake());
    TlsChannel channel = channel(TestAuthority.trusting(authority), "elsewhere.example", "TLSv1.3");

    assertThatThrownBy(() -> shakeHands(channel))
        .isInstanceOf(SSLException.class)
        .hasMessageContaining("elsewhere.example");
  }

  @Test
  void shakeHands_serverSilent_endsInTime() throws Exception {
    TlsChannel channel = channel();

    assertThatThrownBy(() -> channel.shakeHands(selector, new SystemClock(), 50))
        .isInstanceOf(SocketTimeoutException.class)
        .hasMessage("the broker does not answer the TLS handshake");
  }

  @Test
  void shakeHands_serverWithoutTls_fails() throws Exception {
    serve(accepted -> accepted.getOutputStream().write(new byte[] {0x20, 2, 0, 0, 0, 0, 0, 0}));
    TlsChannel channel = channel();

    assertThatThrownBy(() -> shakeHands(channel)).isInstanceOf(IOException.class);
  }

  @Test
  void shakeHands_serverEnds_fails() throws Exception {
    serve(accepted -> accepted.getInputStream().read(new byte[1_000]));
    TlsChannel channel = channel();

    assertThatThrownBy(() -> shakeHands(channel)).isInstanceOf(IOException.class);
  }
}
