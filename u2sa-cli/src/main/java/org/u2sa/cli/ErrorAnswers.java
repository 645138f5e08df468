package org.u2sa.cli;

import java.io.PrintWriter;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.recorder.mcap.record.McapException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Reports errors in one clear line, with a stack trace only if {@code --debug} is given. */
final class ErrorAnswers implements IParameterExceptionHandler, IExecutionExceptionHandler {

  private static final String PREFIX = "u2sa: ";

  private final BooleanSupplier debug;

  ErrorAnswers(BooleanSupplier debug) {
    this.debug = debug;
  }

  @Override
  public int handleParseException(ParameterException e, String[] args) {
    CommandLine command = e.getCommandLine();
    PrintWriter err = command.getErr();
    err.println(PREFIX + message(e, command));
    if (e instanceof UnmatchedArgumentException unmatched) {
      meant(unmatched).ifPresent(name -> err.println("Did you mean " + name + "?"));
    }
    err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
    return ExitCode.BAD_INPUT;
  }

  @Override
  public int handleExecutionException(Exception e, CommandLine command, ParseResult parsed) {
    return answer(e, command.getErr());
  }

  int answer(Throwable thrown, PrintWriter err) {
    Optional<String> provider = ProviderFault.causeOf(thrown);
    boolean badInput =
        provider.isPresent()
            || thrown instanceof BadInputException
            || thrown instanceof McapException; // these messages name the file
    boolean told =
        badInput
            || thrown instanceof RunFailedException
            || thrown instanceof CommunicationException;
    if (told) {
      err.println(PREFIX + provider.orElseGet(thrown::getMessage));
    } else if (thrown instanceof FileSystemException file && file.getFile() != null) {
      err.println(PREFIX + "cannot read or write " + file.getFile() + ": " + reason(file));
    } else {
      err.println(
          PREFIX
              + String.format(
                  "unexpected %s%s",
                  describe(thrown), debug.getAsBoolean() ? "" : " (--debug shows where)"));
    }
    if (debug.getAsBoolean()) {
      thrown.printStackTrace(err);
    }
    return badInput ? ExitCode.BAD_INPUT : ExitCode.FAILED;
  }

  /** Returns the command or option closest to a mistyped one. */
  private static Optional<String> meant(UnmatchedArgumentException e) {
    String typed = e.getUnmatched().get(0).replaceFirst("=.*", "");
    CommandLine command = e.getCommandLine();
    return NearestNames.nearest(
        typed,
        typed.startsWith("-")
            ? command.getCommandSpec().optionsMap().keySet()
            : command.getSubcommands().keySet());
  }

  private static String message(ParameterException e, CommandLine command) {
    if (e instanceof UnmatchedArgumentException unmatched) {
      String typed = unmatched.getUnmatched().get(0);
      String kind =
          typed.startsWith("-")
              ? "option"
              : command.getSubcommands().isEmpty() ? "argument" : "command";
      return "unknown " + kind + " '" + typed + "'";
    }
    // picocli's messages name Java types, which are meaningless to users
    return e.getMessage().replaceFirst("is not an? (long|int)$", "is not a whole number");
  }

  private static String reason(FileSystemException e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof NoSuchFileException) {
      return "no such file or folder";
    }
    if (e instanceof FileAlreadyExistsException) {
      return "a file of that name already exists";
    }
    return e.getReason() == null ? e.getClass().getSimpleName() : e.getReason();
  }

  private static String describe(Throwable thrown) {
    String message = thrown.getMessage();
    String name = thrown.getClass().getSimpleName();
    return message == null ? name : name + ": " + message;
  }
}
