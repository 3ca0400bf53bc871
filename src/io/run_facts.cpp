#include "raytracing/io/run_facts.h"

#include <nlohmann/json.hpp>

namespace raytracing {
namespace {

void add(nlohmann::ordered_json& object, const RunFacts& facts, const FactField& field) {
  const auto add_value = [&](const auto& value) { object[std::string(field.name)] = value; };
  const auto add_member = [&](auto member) {
    const auto& fact = facts.*member;
    if (!fact) return;
    if constexpr (std::is_same_v<decltype(*fact), const FactValue&>)
      std::visit(add_value, *fact);
    else
      add_value(*fact);
  };
  std::visit(add_member, field.member);
}

}  // namespace

nlohmann::ordered_json to_json(const RunFacts& facts) {
  nlohmann::ordered_json object;
  for (const FactField& field : fact_fields()) add(object, facts, field);
  return object;
}

nlohmann::ordered_json to_json(const RunFacts& facts, FactScope scope) {
  nlohmann::ordered_json object;
  for (const FactField& field : fact_fields())
    if (field.scope == scope) add(object, facts, field);
  return object;
}

RunFacts facts_from_json(const nlohmann::ordered_json& object) {
  RunFacts facts;
  for (const FactField& field : fact_fields()) {
    const auto found = object.find(field.name);
    if (found == object.end()) continue;
    read_fact(facts, field, found->is_string() ? found->get<std::string>() : found->dump());
  }
  return facts;
}

}  // namespace raytracing
