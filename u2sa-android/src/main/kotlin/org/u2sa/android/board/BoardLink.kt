package org.u2sa.android.board

import ioio.lib.api.IOIOConnection
import java.util.concurrent.atomic.AtomicReference
import org.u2sa.drivers.ioio.BoardConnection

/**
 * The way to the board by the phone's Bluetooth or USB, and how it is, for whoever shows that or stops the vehicle for it. Safe
 * from any thread.
 *
 * @param address for the log
 * @param attempt makes the connection of one attempt, which reports to the link that it is given
 */
internal class BoardLink(private val address: String, private val attempt: (BoardLink) -> IOIOConnection) :
    BoardConnection, BoardCondition {
    private val standing = AtomicReference<IOIOConnection>()

    /** What went wrong last; empty if nothing. */
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

    /** The end of an older connection than the one that stands changes nothing. */
    fun lost(connection: IOIOConnection, words: String) {
        if (standing.compareAndSet(connection, null) || standing.get() == null) {
            trouble = words.ifEmpty { trouble }
        }
    }
}
