package org.u2sa.interfaces.mqtt.failure;

import java.net.ConnectException;
import java.net.SocketTimeoutException;
import java.security.cert.CertPathValidatorException;
import java.security.cert.CertPathValidatorException.BasicReason;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import javax.net.ssl.SSLException;
import org.eclipse.paho.client.mqttv3.MqttException;

/** What to do about a failed connection to a broker, in a few words for the operator. */
public final class ConnectFailure {
  private static final String LOGIN =
      "--user, --password-file and --ca, or USER, PASSWORD FILE and CA FILE of the Communication"
          + " Manager (docs/security.md)";

  private final String address;
  private final String user;
  private final Instant now;

  /**
   * @param address {@code tcp://HOST:PORT}, or {@code ssl://HOST:PORT} if encrypted
   * @param user as whom it was tried; empty: without a name
   * @param now this machine's time
   */
  public ConnectFailure(String address, String user, Instant now) {
    this.address = address;
    this.user = user;
    this.now = now;
  }

  /**
   * Says what failed and what to do. May ask the broker's port once whether it is encrypted.
   *
   * @param reason message of the failure
   */
  public String text(Throwable failure, String reason) {
    Optional<String> known = certificate(failure);
    String advice = known.isPresent() ? known.get() : ofBroker(failure);
    return advice.isEmpty()
        ? String.format(
            "no Communication Manager at %s: %s; is it running, and is the address right?",
            address, reason)
        : String.format(
            "cannot join the Communication Manager at %s: %s; %s", address, reason, advice);
  }

  /**
   * Whether a broker is there but did not answer in time, or ended the connection without an
   * answer, as one does under a flood: another attempt may succeed.
   */
  public static boolean isPassing(Throwable failure) {
    Optional<MqttException> mqtt = find(failure, MqttException.class);
    return mqtt.isPresent()
        && find(failure, ConnectException.class).isEmpty()
        && find(failure, SSLException.class).isEmpty()
        && (isCode(mqtt.get(), MqttException.REASON_CODE_CLIENT_TIMEOUT)
            || isCode(mqtt.get(), MqttException.REASON_CODE_CONNECTION_LOST)
            || find(failure, SocketTimeoutException.class).isPresent());
  }

  /** What the broker's answer means; empty if unknown. */
  private String ofBroker(Throwable failure) {
    if (isEncrypted()) {
      if (find(failure, SSLException.class).isPresent()) {
        return "is it encrypted? Without TLS, leave out --ca or CA FILE";
      }
    } else if (isCode(failure, MqttException.REASON_CODE_CONNECTION_LOST)
        && EncryptedPort.is(host(), port())) {
      return "it is encrypted and admits users only: " + LOGIN;
    }
    if (isCode(failure, MqttException.REASON_CODE_FAILED_AUTHENTICATION) && !user.isEmpty()) {
      return "user \""
          + user
          + "\" is unknown there, or the password is wrong, or was wrong just before: then wait"
          + " for up to 30 s";
    }
    if (isCode(failure, MqttException.REASON_CODE_NOT_AUTHORIZED)) {
      return user.isEmpty()
          ? "it admits users only: " + LOGIN
          : "user \"" + user + "\" may not join this system; ./u2sa security user list tells whose";
    }
    return "";
  }

  private boolean isEncrypted() {
    return address.startsWith("ssl://");
  }

  private String host() {
    String hostAndPort = address.substring(address.indexOf("://") + 3);
    return hostAndPort.substring(0, hostAndPort.lastIndexOf(':'));
  }

  private int port() {
    return Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
  }

  private Optional<String> certificate(Throwable failure) {
    Optional<CertPathValidatorException> invalid = find(failure, CertPathValidatorException.class);
    if (find(failure, CertificateExpiredException.class).isPresent()
        || find(failure, CertificateNotYetValidException.class).isPresent()) {
      return Optional.of(
          "the broker's certificate is valid "
              + invalid.flatMap(ConnectFailure::validity).orElse("at other times")
              + ", and this machine's clock says "
              + now
              + "; set the clock, or renew the certificate: ./u2sa security certificate");
    }
    boolean isOthers =
        invalid.isPresent() && invalid.get().getReason() == BasicReason.INVALID_SIGNATURE;
    if (isOthers || String.valueOf(failure.getCause()).contains("PKIX path")) {
      return Optional.of(
          "the broker's certificate is not from the authority of --ca or CA FILE: use the ca.pem of"
              + " that broker's SECURITY DIRECTORY");
    }
    return find(failure, CertificateException.class)
        .map(
            e ->
                "the broker's certificate is not for \""
                    + host()
                    + "\": use a name that it has, or make one that has it: ./u2sa security"
                    + " certificate "
                    + host());
  }

  private static Optional<String> validity(CertPathValidatorException invalid) {
    if (invalid.getCertPath() == null || invalid.getIndex() < 0) {
      return Optional.empty();
    }
    List<? extends Certificate> path = invalid.getCertPath().getCertificates();
    return path.get(invalid.getIndex()) instanceof X509Certificate one
        ? Optional.of(
            "from " + one.getNotBefore().toInstant() + " to " + one.getNotAfter().toInstant())
        : Optional.empty();
  }

  private static boolean isCode(Throwable failure, int code) {
    return failure instanceof MqttException mqtt && mqtt.getReasonCode() == code;
  }

  /** The first cause of a kind. */
  static <E extends Throwable> Optional<E> find(Throwable failure, Class<E> kind) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (kind.isInstance(cause)) {
        return Optional.of(kind.cast(cause));
      }
    }
    return Optional.empty();
  }
}
