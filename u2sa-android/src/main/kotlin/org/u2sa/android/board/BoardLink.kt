package org.u2sa.android.board

import ioio.lib.api.IOIOConnection
import java.util.concurrent.atomic.AtomicReference
import org.u2sa.drivers.ioio.BoardConnection

/**
 * Connection to the board over the phone's Bluetooth, USB or network, with its status for the screen and the failsafe. Thread-safe.
 *
 * @param address address shown in the log
 * @param attempt creates the connection of one attempt, which reports to the given link
 */
internal class BoardLink(private val address: String, private val attempt: (BoardLink) -> IOIOConnection) :
    BoardConnection, BoardCondition {
    private val standing = AtomicReference<IOIOConnection>()

    /** Last fault; empty if none. */
    @Volatile
    var trouble = ""
        private set

    override fun newConnection(): IOIOConnection = attempt(this)

    override fun address() = address

    override fun connected(): Boolean = standing.get() != null

    fun established(connection: IOIOConnection) {
        standing.set(connection)
        trouble = ""
    }

    /** Ignores the end of any connection but the current one. */
    fun lost(connection: IOIOConnection, words: String) {
        if (standing.compareAndSet(connection, null) || standing.get() == null) {
            trouble = words.ifEmpty { trouble }
        }
    }
}
