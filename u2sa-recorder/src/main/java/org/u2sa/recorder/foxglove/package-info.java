/**
 * Messages as Foxglove's well-known types in protobuf, so that its and other viewers show them with
 * nothing set up. The schemas are those of github.com/foxglove/foxglove-sdk (MIT), compiled by
 * protoc. What cannot be shown so is no concern of this package: the messages themselves are in the
 * recording.
 */
package org.u2sa.recorder.foxglove;
