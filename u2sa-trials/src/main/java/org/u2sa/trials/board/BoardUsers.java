package org.u2sa.trials.board;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.security.spec.InvalidKeySpecException;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import org.u2sa.core.communication.access.Authenticator;
import org.u2sa.core.communication.access.LoginApplication.Verdict;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * Users and encryption of a served board: those of a security directory. A host encrypts the
 * connection and sends the line {@code LOGIN user password}; the answer is the line {@code OK} or
 * {@code REFUSED reason}. The user needs the role control. Thread-safe.
 */
final class BoardUsers implements AutoCloseable {
  private static final int LONGEST_LINE = 512;
  private static final long ANSWER_WITHIN_S = 20; // the first check waits for a warm-up
  private static final String COMMAND = "LOGIN ";

  private final SSLContext tls;
  private final Users users;
  private final Authenticator authenticator;

  /** An encrypted connection of a user. */
  record LoggedIn(User user, SSLSocket socket) {}

  /**
   * @throws BadInputException if a file is missing, invalid or open to others
   */
  BoardUsers(Path folder, Clock clock, Consumer<String> log) {
    SecurityDirectory directory = new SecurityDirectory(folder);
    directory.check();
    tls = context(directory);
    users = new Users(directory.users(), log);
    authenticator = new Authenticator(users, clock, log);
  }

  private static SSLContext context(SecurityDirectory directory) {
    try (InputStream in = Files.newInputStream(directory.certificate())) {
      KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
      store.load(null, null);
      Certificate[] chain =
          CertificateFactory.getInstance("X.509")
              .generateCertificates(in)
              .toArray(new Certificate[0]);
      store.setKeyEntry("server", key(directory.key()), new char[0], chain);
      KeyManagerFactory keys =
          KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
      keys.init(store, new char[0]);
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(keys.getKeyManagers(), null, null);
      return context;
    } catch (IOException | GeneralSecurityException | IllegalArgumentException e) {
      throw new BadInputException(
          "--security "
              + directory.path()
              + ": server.pem and server-key.pem cannot be used: "
              + e.getMessage(),
          e);
    }
  }

  private static PrivateKey key(Path file) throws IOException, GeneralSecurityException {
    String text = Files.readString(file, StandardCharsets.US_ASCII);
    PKCS8EncodedKeySpec spec =
        new PKCS8EncodedKeySpec(
            Base64.getMimeDecoder().decode(text.replaceAll("-----[A-Z ]+-----", "")));
    try {
      return KeyFactory.getInstance("EC").generatePrivate(spec);
    } catch (InvalidKeySpecException e) {
      return KeyFactory.getInstance("RSA").generatePrivate(spec);
    }
  }

  /**
   * Encrypts a connection and logs its host in; blocks as long as the host does.
   *
   * @throws IOException if the host is not admitted; gives the reason
   */
  LoggedIn admit(Socket plain) throws IOException {
    SSLSocket socket =
        (SSLSocket) tls.getSocketFactory().createSocket(plain, (InputStream) null, true);
    socket.setEnabledProtocols(new String[] {"TLSv1.3", "TLSv1.2"});
    socket.startHandshake();
    byte[] line = line(socket.getInputStream());
    Verdict verdict = verdict(line, plain);
    Optional<User> user = verdict.user().filter(BoardUsers::mayDrive);
    if (user.isEmpty()) {
      String why =
          verdict.user().isPresent() ? "the user lacks the role control" : verdict.reason();
      // must not reveal which names exist
      tell(socket, "REFUSED " + (verdict.isFinal() ? "user, password or role" : why));
      throw new IOException(why);
    }
    return new LoggedIn(user.get(), socket);
  }

  private static boolean mayDrive(User user) {
    return user.roles().contains(AccessRole.CONTROL);
  }

  /** Informs a host whether its log-in succeeded. */
  static void tell(SSLSocket socket, String answer) throws IOException {
    OutputStream out = socket.getOutputStream();
    out.write((answer + '\n').getBytes(StandardCharsets.UTF_8));
    out.flush();
  }

  private static byte[] line(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int octet = in.read(); octet != '\n'; octet = in.read()) {
      if (octet < 0) {
        throw new EOFException("it disconnected before logging in");
      }
      if (line.size() == LONGEST_LINE) {
        throw new IOException("its log-in is longer than " + LONGEST_LINE + " bytes");
      }
      line.write(octet);
    }
    return line.toByteArray();
  }

  private Verdict verdict(byte[] line, Socket from) throws IOException {
    String text = new String(line, StandardCharsets.UTF_8);
    int end = text.indexOf(' ', COMMAND.length());
    if (!text.startsWith(COMMAND) || end < 0) {
      throw new IOException("it sent no \"LOGIN user password\"");
    }
    users.refresh();
    BlockingQueue<Verdict> answer = new ArrayBlockingQueue<>(1);
    authenticator.check(
        text.substring(COMMAND.length(), end),
        text.substring(end + 1).getBytes(StandardCharsets.UTF_8),
        from.getInetAddress(),
        answer::offer);
    try {
      Verdict verdict = answer.poll(ANSWER_WITHIN_S, TimeUnit.SECONDS);
      return verdict == null ? Verdict.later("too many log-ins at once") : verdict;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  /** Whether a user who logged in may still drive: same password, and the role. */
  boolean isStillAdmitted(User user) {
    users.refresh();
    return users
        .named(user.name())
        .filter(now -> now.password().equals(user.password()) && mayDrive(now))
        .isPresent();
  }

  @Override
  public void close() {
    authenticator.close();
  }
}
