#pragma once

#include "rigor/contact/system/contact.hpp"

#include <vector>

namespace rigor {

/// Two faces that lie on each other touch at corners of both, and the normal of a point turns with the face
/// that its corner lies on. Where at least three points, not on one line, hold the faces on each other, one
/// normal serves all of them: makes it turn with B. The equations of the points then depend on each other
/// wherever the bodies are, as within the step of an integrator, and not only where the faces meet.
///
/// A corner of B has a flat surface of B then, and as flat_W of A the normal of A's face (tracked_contact).
/// It stays where it is.
void share_normals_of_faces(std::vector<Contact>& contacts);

}  // namespace rigor
