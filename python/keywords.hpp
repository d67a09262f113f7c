// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/range.hpp"
#include "python/casters.hpp"

namespace alignability::python {

namespace py = pybind11;

/// "str", "numpy.ndarray": what an argument is, for errors.
std::string type_name(py::handle value);

/// The keywords that fill in a struct of options: each is a name and the place of its value. Defaults are those of the struct itself.
template <typename Options>
class Keywords {
 public:
  /// `place` gives of options a reference to the value.
  template <typename Place>
  Keywords& add(std::string name, Place place) {
    using Value = std::remove_reference_t<std::invoke_result_t<Place, Options&>>;
    fields_.push_back({std::move(name), [place](Options& options, py::handle value) { place(options) = value.cast<Value>(); },
                       [place](Options& options, py::handle owner) { return to_python(place(options), owner); }});
    return *this;
  }

  /// The same of a number that has to be in a range, as one in a file has to.
  template <typename Place>
  Keywords& add(std::string name, const Range& allowed, Place place) {
    add(std::move(name), place);
    fields_.back().set = [place, allowed](Options& options, py::handle value) {
      using Value = std::remove_reference_t<std::invoke_result_t<Place, Options&>>;
      const auto given = value.cast<Value>();
      check(given, allowed);
      place(options) = given;
    };
    return *this;
  }

  /// Takes all of them out of a function's keywords. Throws as Python does for those of another name, and for values that do not fit.
  Options read(Options options, const py::kwargs& given, std::string_view function) const {
    for (const std::pair<py::handle, py::handle> keyword : given) {
      set(options, keyword.first.cast<std::string>(), keyword.second, function);
    }
    return options;
  }

  /// "range_min=0.5, stride=1": options as they would be given.
  std::string text_of(Options options) const {
    std::string text;
    for (const Field& field : fields_) {
      const auto value = py::repr(field.get(options, py::none())).template cast<std::string>();
      text.append(text.empty() ? "" : ", ").append(field.name).append("=").append(value);
    }
    return text;
  }

  /// A property of each name, of an object that has such options.
  template <typename Class, typename OptionsOf>
  void add_properties(Class& bound, OptionsOf options_of) const {
    using Owner = typename Class::type;
    for (const Field& field : fields_) {
      bound.def_property(
          field.name.c_str(), [field, options_of](py::object self) { return field.get(options_of(self.cast<Owner&>()), self); },
          [field, options_of](Owner& self, py::handle value) { assign(field, options_of(self), value); });
    }
  }

 private:
  struct Field {
    std::string name;
    std::function<void(Options&, py::handle)> set;
    std::function<py::object(Options&, py::handle owner)> get;
  };

  template <typename Number>
  static void check(Number given, const Range& allowed) {
    if (!allowed.contains(static_cast<double>(given))) throw py::value_error("must be " + allowed.description());
  }
  template <typename Number>
  static void check(const std::optional<Number>& given, const Range& allowed) {
    if (given) check(*given, allowed);
  }

  // What is a class of its own to Python is shared, so that its parts can be set; all else is a copy, for it may be set anew meanwhile.
  template <typename Value>
  static py::object to_python(Value& value, py::handle owner) {
    if constexpr (std::is_base_of_v<py::object, Value>) {
      return value;
    } else if constexpr (std::is_base_of_v<py::detail::type_caster_generic, py::detail::make_caster<Value>>) {
      return py::cast(value, py::return_value_policy::reference_internal, owner);
    } else {
      return py::cast(value, py::return_value_policy::copy);
    }
  }

  static void assign(const Field& field, Options& options, py::handle value) {
    try {
      field.set(options, value);
    } catch (const py::cast_error&) {
      throw py::type_error(field.name + " cannot be " + py::repr(value).cast<std::string>() + ", of type " + type_name(value));
    } catch (const py::value_error& error) {
      throw py::value_error(field.name + ' ' + error.what());
    }
  }

  void set(Options& options, const std::string& name, py::handle value, std::string_view function) const {
    for (const Field& field : fields_) {
      if (field.name == name) return assign(field, options, value);
    }
    throw py::type_error(std::string(function) + "() got an unexpected keyword argument '" + name + "'");
  }

  std::vector<Field> fields_;
};

/// The class of a struct of options: made of keywords, its values properties, shown as it is made.
template <typename Options>
py::class_<Options> bind_options(py::module_& module, const char* name, const char* doc, Keywords<Options> keywords) {
  py::class_<Options> bound(module, name, doc);
  const std::string class_name = name;
  bound.def(py::init([keywords, class_name](const py::kwargs& given) { return keywords.read(Options{}, given, class_name); }));
  keywords.add_properties(bound, [](Options& options) -> Options& { return options; });
  bound.def("__repr__", [keywords, class_name](const Options& options) { return class_name + '(' + keywords.text_of(options) + ')'; });
  return bound;
}

}  // namespace alignability::python
