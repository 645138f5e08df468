package org.u2sa.android.board

/** Whether the board is connected; null if there is no connection to monitor. */
fun interface BoardCondition {
    fun connected(): Boolean?
}
