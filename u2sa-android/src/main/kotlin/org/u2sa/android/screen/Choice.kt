package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.app.Activity
import android.app.AlertDialog
import android.content.Intent
import android.net.Uri
import kotlin.concurrent.thread
import org.u2sa.android.file.Documents
import org.u2sa.android.file.vehicleFiles
import org.u2sa.android.vehicle.AppSettings
import org.u2sa.interfaces.BadInputException

private const val MISSION_REQUEST = 2
private const val SYSTEM_REQUEST = 3

/** Lets the user choose what runs, with Android's own file pickers, and says what is wrong with it. */
internal class Choice(private val activity: Activity, private val settings: AppSettings, private val tell: (String) -> Unit) {
    private val documents = Documents(activity.applicationContext)
    private val files = vehicleFiles(activity)

    /** What is chosen. */
    fun words(): String {
        val own = settings.mission
        val mission = if (own.isEmpty()) Text.MISSION_OF_SYSTEM.of(activity) else Text.MISSION_WITHOUT_FENCE.of(activity, own)
        return Text.CHOSEN.of(activity, settings.system, mission)
    }

    /** Any file: few applications know XML by its type. */
    fun pickMission() {
        val pick = Intent(Intent.ACTION_OPEN_DOCUMENT).addCategory(Intent.CATEGORY_OPENABLE).setType("*/*")
        activity.startActivityForResult(pick, MISSION_REQUEST)
    }

    /** One that is known, or a folder with another. */
    fun pickSystem(): AlertDialog {
        val known = files.systemFiles()
        val entries = known + Text.SYSTEM_FOLDER.of(activity)
        return AlertDialog.Builder(activity)
            .setTitle(Text.MENU_SYSTEM.of(activity))
            .setItems(entries.toTypedArray()) { _, which ->
                if (which < known.size) {
                    take { useSystem(known[which]) }
                } else {
                    activity.startActivityForResult(Intent(Intent.ACTION_OPEN_DOCUMENT_TREE), SYSTEM_REQUEST)
                }
            }
            .show()
    }

    private fun useSystem(name: String): String {
        files.system(name) // refuses what is wrong
        settings.system = name
        settings.mission = "" // that of another vehicle
        return Text.SYSTEM_TAKEN.of(activity, name)
    }

    /** Takes what a picker gave. */
    fun picked(request: Int, uri: Uri) = when (request) {
        MISSION_REQUEST -> take {
            settings.mission = files.importMission(documents.name(uri)) { documents.open(uri) }
            Text.MISSION_TAKEN.of(activity, settings.mission)
        }
        SYSTEM_REQUEST -> take { useSystem(files.import(documents.treeName(uri), documents.below(uri)).first()) }
        else -> Unit
    }

    /** Copies on a thread of its own: documents may come from a network. */
    private fun take(action: () -> String) {
        thread(name = "u2sa-import") {
            val words = try {
                action()
            } catch (e: BadInputException) {
                Text.NOT_TAKEN.of(activity, e.message.orEmpty())
            }
            activity.runOnUiThread { if (!activity.isDestroyed) tell(words) }
        }
    }
}
