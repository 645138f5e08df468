package org.u2sa.android.board

/** Whether the board's connection stands; null if there is none to be watched from here. */
fun interface BoardCondition {
    fun connected(): Boolean?
}
